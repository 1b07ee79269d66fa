#pragma once

#include <vector>

#include "scene/scene.h"
#include "shared/scene_structs.h"

namespace calotype {

/// Quantiles of the film filter: distances from a pixel's centre along one axis, in pixels, which
/// distribute samples like the filter. The share i / kFilterSteps of the filter's weight is below
/// the begin of step i, for i from 0 to kFilterSteps - 1. The filters are products of two equal
/// factors, so one table serves both axes.
std::vector<shared::FilterStep> filterSteps(FilmFilter filter);

} // namespace calotype
