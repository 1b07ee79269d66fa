#include <cmath>
#include <numbers>

#include "reference/coordinates.h"
#include "reference/quadric.h"

namespace calotype::reference {

std::optional<double> intersect(const Disk& disk, const LocalRay& ray) {
    if (std::abs(ray.origin.y) <= ray.tolerance || ray.direction.y == 0.0)
        return std::nullopt;
    const double t = -ray.origin.y / ray.direction.y;
    const glm::dvec3 p = ray.origin + t * ray.direction;
    if (t > 0.0 && std::hypot(p.x, p.z) <= disk.radius)
        return t;
    return std::nullopt;
}

LocalSurface surfaceNear(const Disk& disk, const glm::dvec3& p) {
    return flatFace({p.x, 0.0, p.z}, disk.radius, 1.0);
}

double areaOf(const Disk& disk) { return std::numbers::pi * disk.radius * disk.radius; }

Bounds3d boundsOf(const Disk& disk) {
    const glm::dvec3 corner(disk.radius, 0.0, disk.radius);
    return {-corner, corner};
}

} // namespace calotype::reference
