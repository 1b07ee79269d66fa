#include <cmath>
#include <numbers>

#include "reference/ball.h"
#include "reference/coordinates.h"
#include "reference/quadric.h"

// The solid is the intersection of an infinite cylinder and the slab between the caps. Projected
// along the axis, the infinite cylinder is a circle.

namespace calotype::reference {
namespace {

Interval insideSide(const Cylinder& cylinder, const LocalRay& ray) {
    const glm::dvec2 origin(ray.origin.x, ray.origin.z);
    const glm::dvec2 direction(ray.direction.x, ray.direction.z);
    const double speed = std::hypot(direction.x, direction.y);
    if (speed == 0.0)
        return glm::length(origin) <= cylinder.radius ? Interval() : Interval::nowhere();
    const Interval seen = insideBall(origin, direction / speed, cylinder.radius, ray.tolerance);
    return {seen.enter / speed, seen.leave / speed};
}

} // namespace

std::optional<double> intersect(const Cylinder& cylinder, const LocalRay& ray) {
    const double top = 0.5 * cylinder.height;
    const Interval caps = insideSlab(ray.origin.y, ray.direction.y, -top, top, ray.tolerance);
    return firstCrossing(intersection(insideSide(cylinder, ray), caps));
}

LocalSurface surfaceNear(const Cylinder& cylinder, const glm::dvec3& p) {
    const double radius = cylinder.radius;
    const double height = cylinder.height;
    const double fromAxis = std::hypot(p.x, p.z);
    if (std::abs(std::abs(p.y) - 0.5 * height) < std::abs(fromAxis - radius)) {
        const double up = std::copysign(1.0, p.y);
        return flatFace({p.x, up * 0.5 * height, p.z}, radius, up);
    }
    LocalSurface side;
    side.normal = {p.x / fromAxis, 0.0, p.z / fromAxis};
    side.position = {radius * side.normal.x, p.y, radius * side.normal.z};
    side.uv = {turnsAboutY(p), p.y / height + 0.5};
    side.dpdu = derivativeByTurns(side.position);
    side.dpdv = {0.0, height, 0.0};
    return side;
}

double areaOf(const Cylinder& cylinder) {
    return 2.0 * std::numbers::pi * cylinder.radius * (cylinder.radius + cylinder.height);
}

Bounds3d boundsOf(const Cylinder& cylinder) {
    const glm::dvec3 corner(cylinder.radius, 0.5 * cylinder.height, cylinder.radius);
    return {-corner, corner};
}

} // namespace calotype::reference
