#pragma once

#include "film/tone_map.h"
#include "image/image.h"
#include "image/rgb8_image.h"

namespace calotype {

/// From radiance to what a display shows.
struct DisplayTransform {
    float exposureStops = 0.0f; ///< radiance is multiplied by 2^stops
    ToneMap toneMap = ToneMap::None;
};

/// Exposes, tone maps, encodes as sRGB and rounds to the nearest of 256 levels. Channels that are
/// negative or not finite become 0 first.
Rgb8Image toDisplay(const Image& image, const DisplayTransform& transform);

} // namespace calotype
