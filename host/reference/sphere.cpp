#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "reference/ball.h"
#include "reference/coordinates.h"
#include "reference/quadric.h"

namespace calotype::reference {

std::optional<double> intersect(const Sphere& sphere, const LocalRay& ray) {
    return firstCrossing(insideBall(ray.origin, ray.direction, sphere.radius, ray.tolerance));
}

LocalSurface surfaceNear(const Sphere& sphere, const glm::dvec3& p) {
    LocalSurface surface;
    surface.normal = glm::normalize(p);
    surface.position = sphere.radius * surface.normal;
    // v = theta / pi, where theta is the angle from -y. So y = -r cos(theta), and r sin(theta) is
    // the distance from the axis.
    const double x = surface.position.x;
    const double y = surface.position.y;
    const double z = surface.position.z;
    const double fromAxis = std::hypot(x, z);
    surface.uv = {turnsAboutY(surface.position), std::atan2(fromAxis, -y) / std::numbers::pi};
    surface.dpdu = derivativeByTurns(surface.position);
    surface.dpdv = fromAxis > 0.0 ? std::numbers::pi *
                                        glm::dvec3(-y * x / fromAxis, fromAxis, -y * z / fromAxis)
                                  : glm::dvec3(0.0);
    return surface;
}

double areaOf(const Sphere& sphere) {
    return 4.0 * std::numbers::pi * sphere.radius * sphere.radius;
}

Bounds3d boundsOf(const Sphere& sphere) {
    return {glm::dvec3(-sphere.radius), glm::dvec3(sphere.radius)};
}

} // namespace calotype::reference
