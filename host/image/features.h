#pragma once

#include "image/image.h"
#include "shared/layers.h"

namespace calotype {

/// What one ray of a pixel shows, or the mean of many; the defaults are a ray that shows nothing.
using shared::Features;

using FeatureImage = PixelGrid<Features>;

/// The mean of `rays` > 0 rays' features from their sum; the depth is the mean of those rays that
/// show a surface, and infinite where none does.
Features meanFeatures(const Features& sum, uint32_t rays);

/// Adds the features of a ray to a sum.
void add(const Features& ray, Features& sum);

} // namespace calotype
