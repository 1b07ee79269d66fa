#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "reference/coordinates.h"
#include "reference/interval.h"
#include "reference/quadric.h"

// With y counted from the apex towards the base, the infinite cone is rho <= k y, where k is the
// slope and rho the distance from the axis. Along a line, rho is convex and y linear, so the line
// is inside on one interval. Its ends are among the roots of
//     rho^2 - k^2 y^2 = a t^2 + 2 b t + c,
// which also include those of the mirror image below the apex.

namespace calotype::reference {
namespace {

/// A difference of squares without cancellation of their leading digits.
double differenceOfSquares(double x, double y) { return (x - y) * (x + y); }

/// The interval of a line with a single crossing: beyond it, the line stays inside.
Interval beyond(double crossing, double dy) {
    return dy > 0.0 ? Interval{crossing, kInfinity} : Interval{-kInfinity, crossing};
}

/// `onSide`: the origin is on the surface, so that one root is 0.
Interval insideEndlessCone(const glm::dvec3& o, const glm::dvec3& d, double k, bool onSide) {
    const double a = differenceOfSquares(std::hypot(d.x, d.z), k * d.y);
    const double b = o.x * d.x + o.z * d.z - k * k * o.y * d.y;
    const double c = onSide ? 0.0 : differenceOfSquares(std::hypot(o.x, o.z), k * o.y);
    // b^2 - a c, by Lagrange's identity for the moment o x d, which does not cancel for far
    // origins.
    const glm::dvec3 moment = glm::cross(o, d);
    const double discriminant =
        onSide ? b * b : differenceOfSquares(k * std::hypot(moment.x, moment.z), moment.y);
    const bool isSteep = a <= 0.0; // steeper than the side, or parallel to a line of it
    if (discriminant < 0.0 && !isSteep)
        return Interval::nowhere();
    // A steep line always hits both cones; through the apex, the discriminant is a rounded zero.
    const double q = -(b + std::copysign(std::sqrt(std::max(discriminant, 0.0)), b));
    if (q == 0.0)
        return a < 0.0 ? beyond(0.0, d.y) : Interval::nowhere();
    const double root = c / q;
    if (a == 0.0)
        return beyond(root, d.y);
    const Interval roots = Interval::between(root, q / a);
    if (isSteep)
        return beyond(d.y > 0.0 ? roots.leave : roots.enter, d.y);
    return roots;
}

} // namespace

std::optional<double> intersect(const Cone& cone, const LocalRay& ray) {
    const double depth = std::abs(cone.height);
    const double towardsBase = std::copysign(1.0, cone.height);
    glm::dvec3 o(ray.origin.x, towardsBase * ray.origin.y, ray.origin.z);
    const glm::dvec3 d(ray.direction.x, towardsBase * ray.direction.y, ray.direction.z);
    // From far away b and c cancel, so the line starts at its point nearest to the apex.
    const double reach = depth * std::hypot(1.0, cone.slope);
    const bool isFar = glm::length(o) > 4.0 * reach;
    const double shift = isFar ? -glm::dot(o, d) : 0.0;
    o += shift * d;
    const double overSide = std::hypot(o.x, o.z) - cone.slope * o.y;
    const bool onSide =
        !isFar && o.y >= 0.0 && std::abs(overSide) <= (1.0 + cone.slope) * ray.tolerance;
    const double tolerance = isFar ? 0.0 : ray.tolerance;
    const Interval inside = intersection(insideEndlessCone(o, d, cone.slope, onSide),
                                         insideSlab(o.y, d.y, 0.0, depth, tolerance));
    return firstCrossing({inside.enter + shift, inside.leave + shift});
}

LocalSurface surfaceNear(const Cone& cone, const glm::dvec3& p) {
    const double k = cone.slope;
    const double towardsBase = std::copysign(1.0, cone.height);
    const double fromAxis = std::hypot(p.x, p.z);
    const double toSide = std::abs(fromAxis - k * std::abs(p.y)) / std::hypot(1.0, k);
    if (std::abs(p.y - cone.height) < toSide)
        return flatFace({p.x, cone.height, p.z}, k * std::abs(cone.height), towardsBase);
    LocalSurface side{};
    if (fromAxis == 0.0) {
        side.normal = {0.0, -towardsBase, 0.0};
        side.uv.y = cone.height > 0.0 ? 0.0 : 1.0;
        return side;
    }
    const glm::dvec3 outward(p.x / fromAxis, 0.0, p.z / fromAxis);
    // The foot of the perpendicular from (rho, y) to the line rho = k y.
    const double y = (std::abs(p.y) + k * fromAxis) / (1.0 + k * k);
    side.position = k * y * outward + glm::dvec3(0.0, towardsBase * y, 0.0);
    side.normal = glm::normalize(outward - glm::dvec3(0.0, towardsBase * k, 0.0));
    const double fromApex = y / std::abs(cone.height);
    side.uv = {turnsAboutY(p), cone.height > 0.0 ? fromApex : 1.0 - fromApex};
    side.dpdu = derivativeByTurns(side.position);
    // v grows with y; its derivative is 1 over the height.
    side.dpdv = towardsBase * side.position / fromApex;
    return side;
}

double areaOf(const Cone& cone) {
    const double radius = cone.slope * std::abs(cone.height);
    return std::numbers::pi * radius * (radius + std::hypot(radius, cone.height));
}

Bounds3d boundsOf(const Cone& cone) {
    const double radius = cone.slope * std::abs(cone.height);
    return {{-radius, std::min(0.0, cone.height), -radius},
            {radius, std::max(0.0, cone.height), radius}};
}

} // namespace calotype::reference
