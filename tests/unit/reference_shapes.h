#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include <glm/geometric.hpp>

#include "math/rotation.h"
#include "reference/geometry.h"
#include "scene/scene.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

/// Quadrics of all sizes and places, with points on them and in them made by construction: no ray
/// is followed to find them.
namespace calotype::test {

enum class QuadricKind { Sphere, Cylinder, Cone, Disk };
inline constexpr std::array kQuadricKinds = {QuadricKind::Sphere, QuadricKind::Cylinder,
                                             QuadricKind::Cone, QuadricKind::Disk};

inline std::string nameOf(QuadricKind kind) {
    constexpr const char* kNames[] = {"Sphere", "Cylinder", "Cone", "Disk"};
    return kNames[static_cast<int>(kind)];
}

inline glm::dmat3 someRotation(RandomNumbers& random) {
    if (random.coin())
        return glm::dmat3(1.0);
    const glm::dmat3 mirror(-1, 0, 0, 0, 1, 0, 0, 0, 1);
    return rotationTakingYTo(random.direction()) * (random.coin() ? mirror : glm::dmat3(1.0)) *
           rotationFromDegrees({0.0, random.between(0.0, 360.0), 0.0});
}

/// A shape of material 0 whose largest measure is within a factor of two of `size`.
inline Shape randomQuadric(QuadricKind kind, const glm::dvec3& center, double size,
                           RandomNumbers& random) {
    const RigidTransform frame{someRotation(random), center};
    const double ratio = random.powerOfTen(-2.0, 2.0);
    const double small = size * std::min(ratio, 1.0);
    const double other = size * std::min(1.0 / ratio, 1.0);
    switch (kind) {
    case QuadricKind::Sphere:
        return shapeOf(Sphere{frame, size});
    case QuadricKind::Cylinder:
        return shapeOf(Cylinder{frame, small, other});
    case QuadricKind::Cone:
        return shapeOf(Cone{frame, random.sign() * other, ratio});
    default:
        return shapeOf(Disk{frame, size});
    }
}

struct SurfacePoint {
    glm::dvec3 position;
    glm::dvec3 normal;      ///< outward
    double radius;          ///< of the surface's strongest curvature there; infinity where flat
    glm::dvec3 pointInside; ///< another one, in the open solid; of a disk, beneath it
};

/// In the shape's frame; no nearer to a rim or an apex than a thousandth of the way across a face.
class PointMaker {
public:
    explicit PointMaker(RandomNumbers& random) : random_(random) {}

    SurfacePoint operator()(const Sphere& sphere) {
        const glm::dvec3 normal = random_.direction();
        return {sphere.radius * normal, normal, sphere.radius,
                0.999 * sphere.radius * random_.inBall()};
    }

    SurfacePoint operator()(const Cylinder& cylinder) {
        const double top = 0.5 * cylinder.height;
        const double radius = cylinder.radius;
        const glm::dvec3 inside = at(radius * fraction(), random_.sign() * top * fraction());
        if (random_.coin()) {
            const double up = random_.sign();
            return {at(radius * fraction(), up * top), {0.0, up, 0.0}, kFlat, inside};
        }
        const glm::dvec3 p = at(radius, random_.sign() * top * fraction());
        return {p, glm::dvec3(p.x, 0.0, p.z) / radius, radius, inside};
    }

    SurfacePoint operator()(const Cone& cone) {
        const double radiusPerY = cone.slope * std::copysign(1.0, cone.height);
        const double insideY = cone.height * fraction();
        const glm::dvec3 inside = at(radiusPerY * insideY * fraction(), insideY);
        const double y = cone.height * fraction();
        const double down = std::copysign(1.0, cone.height);
        if (random_.coin())
            return {at(radiusPerY * cone.height * fraction(), cone.height),
                    {0.0, down, 0.0},
                    kFlat,
                    inside};
        const glm::dvec3 p = at(radiusPerY * y, y);
        const double rho = radiusPerY * y;
        const glm::dvec3 normal =
            glm::normalize(glm::dvec3(p.x / rho, -down * cone.slope, p.z / rho));
        return {p, normal, rho * std::hypot(1.0, cone.slope), inside};
    }

    SurfacePoint operator()(const Disk& disk) {
        return {at(disk.radius * fraction(), 0.0),
                {0.0, 1.0, 0.0},
                kFlat,
                at(disk.radius * fraction(), -disk.radius * fraction())};
    }

    SurfacePoint operator()(const Mesh&) { return {}; }

private:
    static constexpr double kFlat = std::numeric_limits<double>::infinity();

    double fraction() { return random_.between(0.001, 0.999); }

    glm::dvec3 at(double radius, double y) {
        const double phi = 2.0 * std::numbers::pi * random_.unit();
        return {radius * std::cos(phi), y, radius * std::sin(phi)};
    }

    RandomNumbers& random_;
};

inline const RigidTransform& frameOf(const Shape& shape) {
    return std::visit(
        []<typename Geometry>(const Geometry& geometry) -> const RigidTransform& {
            static const RigidTransform kWorld;
            if constexpr (std::is_same_v<Geometry, Mesh>)
                return kWorld;
            else
                return geometry.worldFromObject;
        },
        shape.geometry);
}

/// In the world.
inline SurfacePoint pointOf(const Shape& shape, RandomNumbers& random) {
    const SurfacePoint local = std::visit(PointMaker(random), shape.geometry);
    const RigidTransform& frame = frameOf(shape);
    return {frame.point(local.position), frame.direction(local.normal), local.radius,
            frame.point(local.pointInside)};
}

/// A unit vector whose cosine to `normal` is at least 0.01, every other one below 0.1.
inline glm::dvec3 directionAbove(const glm::dvec3& normal, RandomNumbers& random,
                                 double lowestPower = -2.0) {
    const glm::dvec3 tangent = glm::normalize(glm::cross(normal, random.direction()));
    const double cosine =
        random.coin() ? random.between(0.1, 1.0) : random.powerOfTen(lowestPower, -1.0);
    return glm::normalize(cosine * normal + std::sqrt(1.0 - cosine * cosine) * tangent);
}

inline double magnitude(const glm::dvec3& p) {
    return std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)});
}

} // namespace calotype::test
