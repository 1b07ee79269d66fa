#include "reference/camera.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "reference/warp.h"

namespace calotype::reference {
namespace {

/// The integral of a one-dimensional filter from its centre to x >= 0, up to a factor; its support
/// ends at `radius`.
struct FilterIntegral {
    double radius;
    double (*upTo)(double x);
};

FilterIntegral integralOf(FilmFilter filter) {
    switch (filter) {
    case FilmFilter::Box:
        return {0.5, [](double x) { return x; }};
    case FilmFilter::Tent: // 1 - x
        return {1.0, [](double x) { return x - 0.5 * x * x; }};
    case FilmFilter::Gaussian: // exp(-x^2 / (2 sigma^2)) with sigma 1/2
        return {1.5, [](double x) { return std::erf(std::numbers::sqrt2 * x); }};
    case FilmFilter::BlackmanHarris:
        break;
    }
    // a0 + a1 cos w + a2 cos 2w + a3 cos 3w about the centre, w = pi x / radius (Harris 1978).
    return {1.5, [](double x) {
                const double w = kPi * x / 1.5;
                return 0.35875 * w + 0.48829 * std::sin(w) + 0.14128 / 2.0 * std::sin(2.0 * w) +
                       0.01168 / 3.0 * std::sin(3.0 * w);
            }};
}

/// The signed distance from the centre with the share u of the filter below it.
double invert(const FilterIntegral& filter, double u) {
    const double share = std::abs(2.0 * u - 1.0) * filter.upTo(filter.radius);
    double low = 0.0;
    double high = filter.radius;
    for (double x = 0.5 * high; low < x && x < high; x = 0.5 * (low + high))
        (filter.upTo(x) < share ? low : high) = x;
    return std::copysign(low, u - 0.5);
}

} // namespace

glm::dvec2 samplePixel(FilmFilter filter, const glm::dvec2& u) {
    const FilterIntegral integral = integralOf(filter);
    return {0.5 + invert(integral, u.x), 0.5 + invert(integral, u.y)};
}

Ray cameraRay(const Camera& camera, const glm::uvec2& imageSize, const glm::dvec2& filmPosition,
              const glm::dvec2& uLens) {
    const bool isOrthographic = camera.projection == Projection::Orthographic;
    const double halfHeight =
        isOrthographic ? 0.5 * camera.viewHeight : std::tan(0.5 * camera.verticalFov);
    const glm::dvec2 size(imageSize);
    // In half heights of the film, from its centre to the right and up.
    const glm::dvec2 onFilm((2.0 * filmPosition.x - size.x) / size.y,
                            1.0 - 2.0 * filmPosition.y / size.y);
    const glm::dvec3 aside = halfHeight * (onFilm.x * camera.right + onFilm.y * camera.up);
    const glm::dvec3 pinhole = isOrthographic ? camera.position + aside : camera.position;
    const glm::dvec3 axis = isOrthographic ? camera.forward : camera.forward + aside;
    const glm::dvec3 inFocus = pinhole + camera.focusDistance * axis;
    const glm::dvec2 lens = camera.lensRadius * warpToDisk(uLens);
    const glm::dvec3 origin = pinhole + lens.x * camera.right + lens.y * camera.up;
    const glm::dvec3 direction = camera.lensRadius > 0.0 ? inFocus - origin : axis;
    return {origin, glm::normalize(direction)};
}

} // namespace calotype::reference
