#pragma once

#include <vector>

#include "scene/scene.h"

namespace calotype {

/// Distances from a pixel's centre along one axis, in pixels, by which the film filter's samples
/// are spread: entry i of kFilterSteps + 1 is the distance below which the share i / kFilterSteps
/// of the filter's weight lies. The filters are products of two equal factors, so one table serves
/// both axes.
std::vector<float> filterQuantiles(FilmFilter filter);

} // namespace calotype
