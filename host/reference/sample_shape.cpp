#include "reference/sample_shape.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "reference/warp.h"

namespace calotype::reference {
namespace {

ShapePoint inWorld(const RigidTransform& worldFromObject, const glm::dvec3& position,
                   const glm::dvec3& normal) {
    return {worldFromObject.point(position), worldFromObject.direction(normal)};
}

glm::dvec3 inObject(const RigidTransform& worldFromObject, const glm::dvec3& world) {
    return glm::transpose(worldFromObject.rotation) * (world - worldFromObject.translation);
}

/// A point in the plane of a cap at height y.
glm::dvec3 onCap(double radius, double y, const glm::dvec2& u) {
    const glm::dvec2 p = radius * warpToDisk(u);
    return {p.x, y, p.y};
}

/// The horizontal unit vector at an angle of `turns` about +Y, from x towards z.
glm::dvec3 aroundAxis(double turns) {
    return {std::cos(2.0 * kPi * turns), 0.0, std::sin(2.0 * kPi * turns)};
}

/// 1 - cos of the half angle that a sphere subtends; its sine is r / distance.
double oneMinusConeCosine(double sin2) { return sin2 / (1.0 + std::sqrt(1.0 - sin2)); }

double seenSin2(const Sphere& sphere, const glm::dvec3& shadingPoint) {
    const glm::dvec3 away = shadingPoint - sphere.worldFromObject.translation;
    return sphere.radius * sphere.radius / glm::dot(away, away);
}

} // namespace

ShapePoint samplePoint(const Sphere& sphere, const glm::dvec2& u) {
    const glm::dvec3 normal = warpToSphere(u);
    return inWorld(sphere.worldFromObject, sphere.radius * normal, normal);
}

/// u.x covers the lower cap, the side, and the upper cap backwards, in proportion to their areas.
ShapePoint samplePoint(const Cylinder& cylinder, const glm::dvec2& u) {
    const double r = cylinder.radius;
    const double h = cylinder.height;
    const double capShare = 0.5 * r / (r + h);
    if (u.x < capShare)
        return inWorld(cylinder.worldFromObject, onCap(r, -0.5 * h, {u.x / capShare, u.y}),
                       {0.0, -1.0, 0.0});
    if (u.x >= 1.0 - capShare)
        return inWorld(cylinder.worldFromObject, onCap(r, 0.5 * h, {(1.0 - u.x) / capShare, u.y}),
                       {0.0, 1.0, 0.0});
    const double y = ((u.x - capShare) / (1.0 - 2.0 * capShare) - 0.5) * h;
    const glm::dvec3 outward = aroundAxis(u.y);
    return inWorld(cylinder.worldFromObject, r * outward + glm::dvec3(0.0, y, 0.0), outward);
}

/// u.x covers the base and the side, in proportion to their areas; the circumference of the side
/// grows with the distance from the apex.
ShapePoint samplePoint(const Cone& cone, const glm::dvec2& u) {
    const double h = cone.height;
    const double r = cone.slope * std::abs(h);
    const double baseShare = r / (r + std::hypot(r, h));
    const double down = std::copysign(1.0, h); // from the apex to the base, along y
    if (u.x < baseShare)
        return inWorld(cone.worldFromObject, onCap(r, h, {u.x / baseShare, u.y}), {0.0, down, 0.0});
    const double fromApex = std::sqrt((u.x - baseShare) / (1.0 - baseShare));
    const glm::dvec3 outward = aroundAxis(u.y);
    const glm::dvec3 normal = glm::normalize(outward - glm::dvec3(0.0, down * cone.slope, 0.0));
    return inWorld(cone.worldFromObject, fromApex * (r * outward + glm::dvec3(0.0, h, 0.0)),
                   normal);
}

ShapePoint samplePoint(const Disk& disk, const glm::dvec2& u) {
    return inWorld(disk.worldFromObject, onCap(disk.radius, 0.0, u), {0.0, 1.0, 0.0});
}

ShapePoint samplePoint(const Mesh& mesh, uint32_t triangle, const glm::dvec2& u) {
    const uint32_t* corners = mesh.triangles[triangle].position;
    const glm::dvec3& a = mesh.positions[corners[0]];
    const glm::dvec3 ab = mesh.positions[corners[1]] - a;
    const glm::dvec3 ac = mesh.positions[corners[2]] - a;
    const glm::dvec2 weights = warpToTriangle(u);
    return {a + weights.x * ab + weights.y * ac, glm::normalize(glm::cross(ab, ac))};
}

double sphereConePdf(const Sphere& sphere, const glm::dvec3& shadingPoint) {
    return 1.0 / (2.0 * kPi * oneMinusConeCosine(seenSin2(sphere, shadingPoint)));
}

/// Let theta be the angle at `shadingPoint` from the axis, which goes to the centre. The near point
/// of the sphere in that direction is at the angle beta - theta to the axis at the centre; by the
/// law of sines, sin beta is sin theta / sin thetaMax.
ShapePoint sampleSeenSphere(const Sphere& sphere, const glm::dvec3& shadingPoint,
                            const glm::dvec2& u) {
    const double sin2Max = seenSin2(sphere, shadingPoint);
    const double oneMinusCos = u.x * oneMinusConeCosine(sin2Max);
    const double theta = 2.0 * std::asin(std::sqrt(0.5 * oneMinusCos));
    const double beta = std::asin(std::min(std::sin(theta) / std::sqrt(sin2Max), 1.0));
    const glm::dmat3 frame =
        frameAbout(glm::normalize(shadingPoint - sphere.worldFromObject.translation));
    const double angle = beta - theta;
    const glm::dvec2 around(std::cos(2.0 * kPi * u.y), std::sin(2.0 * kPi * u.y));
    const glm::dvec3 normal =
        frame * glm::dvec3(std::sin(angle) * around.x, std::sin(angle) * around.y, std::cos(angle));
    return {sphere.worldFromObject.translation + sphere.radius * normal, normal};
}

/// Compares the squares that seenSin2 divides: outside, their ratio is at most 1.
bool contains(const Sphere& sphere, const glm::dvec3& point) {
    const glm::dvec3 away = point - sphere.worldFromObject.translation;
    return glm::dot(away, away) < sphere.radius * sphere.radius;
}

bool contains(const Cylinder& cylinder, const glm::dvec3& point) {
    const glm::dvec3 p = inObject(cylinder.worldFromObject, point);
    return std::abs(p.y) <= 0.5 * cylinder.height && std::hypot(p.x, p.z) < cylinder.radius;
}

bool contains(const Cone& cone, const glm::dvec3& point) {
    const glm::dvec3 p = inObject(cone.worldFromObject, point);
    const double fromApex = p.y * std::copysign(1.0, cone.height);
    return fromApex >= 0.0 && fromApex <= std::abs(cone.height) &&
           std::hypot(p.x, p.z) < cone.slope * fromApex;
}

} // namespace calotype::reference
