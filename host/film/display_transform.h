#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "film/tone_map.h"
#include "image/image.h"

namespace calotype {

/// Converts radiance to display values.
struct DisplayTransform {
    /// Radiance is multiplied by 2^stops; none: by exposureOf the picture.
    std::optional<float> exposureStops = 0.0f;
    ToneMap toneMap = ToneMap::None;
};

/// The exposure, in stops, with which the key luminance of a picture becomes middle grey. Rounded
/// to tenths, so that a printed number gives the same picture. 0 for a black picture.
float exposureOf(const Image& image);

/// The transform with the exposure that it leaves to the picture.
DisplayTransform withExposureOf(const Image& image, DisplayTransform transform);

/// Exposes, tone maps, encodes as sRGB and rounds to the nearest of 256 levels. Channels that are
/// negative or not finite become 0 first.
/// `alpha`, if it is not empty, has the pixels' alpha, by which their colours are divided first; a
/// pixel of alpha 0 is black.
Rgb8Image toDisplay(const Image& image, const DisplayTransform& transform,
                    std::span<const float> alpha = {});

/// Rounds alpha to the nearest of 256 levels; what is not in [0, 1] is clamped, NaN is 0.
std::vector<uint8_t> alphaLevels(std::span<const float> alpha);

} // namespace calotype
