#include "math/rotation.h"

#include <cmath>
#include <numbers>

namespace calotype {
namespace {

struct SineCosine {
    double sine;
    double cosine;
};

SineCosine sineCosine(double degrees) {
    // std::remquo is exact: the remainder is in [-45, 45].
    int quarterTurns = 0;
    const double rest = std::remquo(degrees, 90.0, &quarterTurns);
    const double radians = rest * (std::numbers::pi / 180.0);
    const double s = std::sin(radians);
    const double c = std::cos(radians);
    switch (quarterTurns & 3) {
    case 0:
        return {s, c};
    case 1:
        return {c, -s};
    case 2:
        return {-s, -c};
    default:
        return {-c, s};
    }
}

} // namespace

glm::dmat3 rotationFromDegrees(const glm::dvec3& degrees) {
    const auto [sx, cx] = sineCosine(degrees.x);
    const auto [sy, cy] = sineCosine(degrees.y);
    const auto [sz, cz] = sineCosine(degrees.z);
    const glm::dmat3 aboutX(1, 0, 0, 0, cx, sx, 0, -sx, cx);
    const glm::dmat3 aboutY(cy, 0, -sy, 0, 1, 0, sy, 0, cy);
    const glm::dmat3 aboutZ(cz, sz, 0, -sz, cz, 0, 0, 0, 1);
    return aboutZ * aboutY * aboutX;
}

glm::dmat3 rotationTakingYTo(const glm::dvec3& direction) {
    const double x = direction.x;
    const double y = direction.y;
    const double z = direction.z;
    const double sign = std::copysign(1.0, y);
    const double a = -1.0 / (sign + y);
    const double b = z * x * a;
    const glm::dvec3 imageOfX(sign + x * x * a, -x, b);
    const glm::dvec3 imageOfZ(sign * b, -sign * z, 1.0 + sign * z * z * a);
    return {imageOfX, direction, imageOfZ};
}

} // namespace calotype
