#include "image/false_color.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/constants.hpp>
#include <glm/vec3.hpp>

#include "image/srgb.h"

namespace calotype {
namespace {

/// The helix, its hues in degrees. Up to a chroma of 0.169 all its colours are in sRGB.
constexpr double kFirstLightness = 0.25;
constexpr double kLastLightness = 0.90;
constexpr double kFirstHue = 265.0;
constexpr double kLastHue = 465.0;
constexpr double kChroma = 0.165;

double cube(double x) { return x * x * x; }

/// Linear Rec. 709 of an Oklab colour, by Ottosson's matrices.
glm::dvec3 linearFromOklab(double lightness, double a, double b) {
    const double l = cube(lightness + 0.3963377774 * a + 0.2158037573 * b);
    const double m = cube(lightness - 0.1055613458 * a - 0.0638541728 * b);
    const double s = cube(lightness - 0.0894841775 * a - 1.2914855480 * b);
    return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
            -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
            -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

uint8_t encode(double linear) {
    const float encoded = srgbFromLinear(static_cast<float>(std::clamp(linear, 0.0, 1.0)));
    return static_cast<uint8_t>(std::lround(255.0f * encoded));
}

} // namespace

glm::u8vec3 falseColor(double position) {
    const double t = std::clamp(position, 0.0, 1.0);
    const double lightness = kFirstLightness + t * (kLastLightness - kFirstLightness);
    const double hue = (kFirstHue + t * (kLastHue - kFirstHue)) * glm::pi<double>() / 180.0;
    const glm::dvec3 linear =
        linearFromOklab(lightness, kChroma * std::cos(hue), kChroma * std::sin(hue));
    return {encode(linear.r), encode(linear.g), encode(linear.b)};
}

} // namespace calotype
