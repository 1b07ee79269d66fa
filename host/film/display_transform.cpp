#include "film/display_transform.h"

#include <algorithm>
#include <cmath>

#include "image/key_luminance.h"
#include "image/srgb.h"

namespace calotype {
namespace {

/// White under every tone map, and small enough that none of their computations overflows.
constexpr float kBrightest = 1e20f;

float expose(float radiance, float gain) {
    return std::isfinite(radiance) && radiance > 0.0f ? std::min(radiance * gain, kBrightest)
                                                      : 0.0f;
}

uint8_t level(float unit) { return static_cast<uint8_t>(255.0f * unit + 0.5f); }

uint8_t quantise(float unit) { return level(srgbFromLinear(unit)); }

/// The colour of the part of a pixel that is covered.
glm::vec3 unmultiplied(const glm::vec3& color, float alpha) {
    return alpha > 0.0f ? color / std::min(alpha, 1.0f) : glm::vec3(0.0f);
}

} // namespace

float exposureOf(const Image& image) {
    const double key = keyLuminance(image);
    const double stops = key > 0.0 ? std::log2(kMiddleGrey / key) : 0.0;
    return static_cast<float>(std::round(10.0 * stops) / 10.0 + 0.0); // never -0
}

DisplayTransform withExposureOf(const Image& image, DisplayTransform transform) {
    if (!transform.exposureStops)
        transform.exposureStops = exposureOf(image);
    return transform;
}

Rgb8Image toDisplay(const Image& image, const DisplayTransform& transform,
                    std::span<const float> alpha) {
    const float gain = std::exp2(*withExposureOf(image, transform).exposureStops);
    Rgb8Image shown(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3 pixel =
            alpha.empty() ? image.pixels[i] : unmultiplied(image.pixels[i], alpha[i]);
        const glm::vec3 exposed(expose(pixel.r, gain), expose(pixel.g, gain),
                                expose(pixel.b, gain));
        const glm::vec3 mapped = applyToneMap(transform.toneMap, exposed);
        shown.pixels[i] = {quantise(mapped.r), quantise(mapped.g), quantise(mapped.b)};
    }
    return shown;
}

std::vector<uint8_t> alphaLevels(std::span<const float> alpha) {
    std::vector<uint8_t> levels;
    levels.reserve(alpha.size());
    for (const float share : alpha)
        levels.push_back(level(share > 0.0f ? std::min(share, 1.0f) : 0.0f));
    return levels;
}

} // namespace calotype
