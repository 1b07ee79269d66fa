#include "film/display_transform.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "image/srgb.h"

namespace calotype {
namespace {

float minChannel(const glm::vec3& c) { return glm::min(c.r, glm::min(c.g, c.b)); }
float maxChannel(const glm::vec3& c) { return glm::max(c.r, glm::max(c.g, c.b)); }

/// With x the smallest channel, p the largest after the toe, s = 0.76 and d = 1 - s:
///
/// Toe: c -= x - 6.25 x^2 for x < 0.08, else 0.04, which undoes the Fresnel reflection of F0 =
/// 0.04.
///
/// Shoulder: for p >= s, n = 1 - d^2 / (p + d - s) and c *= n / p: p becomes n, which approaches 1.
///
/// Bleach: c is mixed with white n by 1 - 1 / (0.15 (p - n) + 1).
///
/// Source: Khronos PBR Neutral Tone Mapper specification, 2024
/// (github.com/KhronosGroup/ToneMapping, PBR_Neutral).
glm::vec3 neutral(glm::vec3 color) {
    constexpr float kShoulder = 0.8f - 0.04f;
    constexpr float kRange = 1.0f - kShoulder;
    constexpr float kDesaturation = 0.15f;

    const float x = minChannel(color);
    color -= glm::vec3(x < 0.08f ? x - 6.25f * x * x : 0.04f);
    const float peak = maxChannel(color);
    if (peak < kShoulder)
        return color;
    const float newPeak = 1.0f - kRange * kRange / (peak + kRange - kShoulder);
    const float bleach = 1.0f - 1.0f / (kDesaturation * (peak - newPeak) + 1.0f);
    return glm::mix(color * (newPeak / peak), glm::vec3(newPeak), bleach);
}

/// Reinhard, Stark, Shirley, Ferwerda 2002, eq. 3, on the largest channel instead of luminance.
glm::vec3 reinhard(const glm::vec3& color) { return color / (1.0f + maxChannel(color)); }

/// White under every tone map, and small enough that none of their computations overflows.
constexpr float kBrightest = 1e20f;

float expose(float radiance, float gain) {
    return std::isfinite(radiance) && radiance > 0.0f ? std::min(radiance * gain, kBrightest)
                                                      : 0.0f;
}

uint8_t quantise(float unit) { return static_cast<uint8_t>(255.0f * srgbFromLinear(unit) + 0.5f); }

} // namespace

std::optional<ToneMap> toneMapFromName(std::string_view name) {
    if (name == "none")
        return ToneMap::None;
    if (name == "neutral")
        return ToneMap::Neutral;
    if (name == "reinhard")
        return ToneMap::Reinhard;
    return std::nullopt;
}

glm::vec3 applyToneMap(ToneMap toneMap, glm::vec3 color) {
    switch (toneMap) {
    case ToneMap::None:
        break;
    case ToneMap::Neutral:
        color = neutral(color);
        break;
    case ToneMap::Reinhard:
        color = reinhard(color);
        break;
    }
    return glm::clamp(color, glm::vec3(0.0f), glm::vec3(1.0f));
}

Rgb8Image toDisplay(const Image& image, const DisplayTransform& transform) {
    const float gain = std::exp2(transform.exposureStops);
    Rgb8Image shown(image.width, image.height);
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const glm::vec3& pixel = image.pixels[i];
        const glm::vec3 exposed(expose(pixel.r, gain), expose(pixel.g, gain),
                                expose(pixel.b, gain));
        const glm::vec3 mapped = applyToneMap(transform.toneMap, exposed);
        shown.pixels[i] = {quantise(mapped.r), quantise(mapped.g), quantise(mapped.b)};
    }
    return shown;
}

} // namespace calotype
