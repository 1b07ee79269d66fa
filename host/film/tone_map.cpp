#include "film/tone_map.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include "image/key_luminance.h"

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

/// How far the primaries of Rec. 709 are moved towards white in CIE xy: a fifth of the way. A row
/// of `inset` mixes four fifths of a channel with a fifth of all three. The shares of all three are
/// the sums X + Y + Z of the primaries (IEC 61966-2-1) over that of white.
class AgxPrimaries {
public:
    static glm::dvec3 inset(const glm::dvec3& c) { return kKept * c + kMixed * dot(kShares, c); }
    /// The inverse: the shares sum to 1, so `inset` keeps dot(kShares, c).
    static glm::dvec3 outset(const glm::dvec3& c) { return (c - kMixed * dot(kShares, c)) / kKept; }

private:
    static constexpr double kMixed = 0.2;
    static constexpr double kKept = 1.0 - kMixed;
    static constexpr glm::dvec3 kShares = glm::dvec3(0.6443, 1.1920, 1.2032) / 3.0395;
};

/// Let x be the place of a channel on a logarithmic scale from 10 stops below middle grey, 0.18, to
/// 6.5 above, p that of middle grey, and b = 3 below p and 3.25 above:
///
///     y = 1/2 + 2 (x - p) (1 + a |x - p|^b)^(-1/b)
///
/// with slope 2 at middle grey, which becomes 1/2, and the a for which 0 becomes 0 and 1 becomes 1:
/// a = 4^b - q^-b, where q is the distance of that end from p.
double agxCurve(double channel) {
    constexpr double kStopsBelow = 10.0;
    constexpr double kStopsAbove = 6.5;
    constexpr double kRange = kStopsBelow + kStopsAbove;
    const double stops = std::log2(channel / kMiddleGrey);
    if (!(stops > -kStopsBelow))
        return 0.0;
    const double fromPivot = std::min(stops, kStopsAbove) / kRange;
    const double power = fromPivot < 0.0 ? 3.0 : 3.25;
    const double end = (fromPivot < 0.0 ? kStopsBelow : kStopsAbove) / kRange;
    const double bend = std::pow(4.0, power) - std::pow(end, -power);
    return 0.5 + 2.0 * fromPivot *
                     std::pow(1.0 + bend * std::pow(std::abs(fromPivot), power), -1.0 / power);
}

/// The channels in less saturated primaries, each through a curve, and back. The result is encoded
/// for a display of gamma 2.2, which is undone here.
///
/// Sources: Sobotka, AgX, 2022 (github.com/sobotka/AgX) for the primaries and the curve, without a
/// look; Wrensch, "Minimal AgX Implementation", 2023 (iolite-engine.com) for the way back.
glm::vec3 agx(const glm::vec3& color) {
    const glm::dvec3 inset = AgxPrimaries::inset(glm::dvec3(color));
    const glm::dvec3 curved(agxCurve(inset.r), agxCurve(inset.g), agxCurve(inset.b));
    const glm::dvec3 encoded = glm::max(AgxPrimaries::outset(curved), 0.0);
    return glm::vec3(glm::pow(encoded, glm::dvec3(2.2)));
}

} // namespace

std::optional<ToneMap> toneMapFromName(std::string_view name) {
    if (name == "none")
        return ToneMap::None;
    if (name == "neutral")
        return ToneMap::Neutral;
    if (name == "reinhard")
        return ToneMap::Reinhard;
    if (name == "agx")
        return ToneMap::Agx;
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
    case ToneMap::Agx:
        color = agx(color);
        break;
    }
    return glm::clamp(color, glm::vec3(0.0f), glm::vec3(1.0f));
}

} // namespace calotype
