#pragma once

#include <cstdint>
#include <functional>
#include <span>

#include "image/first_hit.h"
#include "image/image.h"
#include "shared/layers.h"

namespace calotype {

/// What one ray of a pixel shows, or the mean of many; the defaults are a ray that shows nothing.
using shared::Features;

using FeatureImage = PixelGrid<Features>;

/// What one ray shows, and the number of the first primitive that it shows, or kNoPrimitive.
struct RayFeatures {
    Features features;
    uint32_t primitive = kNoPrimitive;
};

/// Called after each of the rays that the features are the mean of, with the primitive that it
/// shows in each pixel, row by row from the top left one, or kNoPrimitive. May be empty.
using OnPrimitives = std::function<void(std::span<const uint32_t> primitives)>;

/// The mean of `rays` > 0 rays' features from their sum; the depth is the mean of those rays that
/// show a surface, and infinite where none does.
Features meanFeatures(const Features& sum, uint32_t rays);

/// Adds the features of a ray to a sum.
void add(const Features& ray, Features& sum);

} // namespace calotype
