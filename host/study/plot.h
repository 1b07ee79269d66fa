#pragma once

#include <string>

#include "study/study.h"

namespace calotype {

/// The colour of the i-th variant, "#rrggbb", in plots and pages.
std::string variantColor(size_t index);

/// Error against time, both logarithmic, a line a variant, and the Pareto front, as an SVG that
/// needs no other file: for light and dark backgrounds, with a legend.
std::string toSvg(const Study& study, const std::string& title);

} // namespace calotype
