#include "support/oracle_quadric.h"

#include <cmath>

#include "support/oracle_cone.h"
#include "support/oracle_cylinder.h"
#include "support/oracle_disk.h"
#include "support/oracle_sphere.h"

namespace calotype::test {
namespace {

/// A sphere's frame is the world's: it needs none, and rounding has its axes off the right angle.
Vec3 localDirection(const shared::Quadric& quadric, const Vec3& world) {
    if (quadric.kind == shared::kSphere)
        return world;
    return {glm::dot(world, Vec3(quadric.axisX)), glm::dot(world, Vec3(quadric.axisY)),
            glm::dot(world, Vec3(quadric.axisZ))};
}

Vec3 worldDirection(const shared::Quadric& quadric, const Vec3& local) {
    if (quadric.kind == shared::kSphere)
        return local;
    return local.x * Vec3(quadric.axisX) + local.y * Vec3(quadric.axisY) +
           local.z * Vec3(quadric.axisZ);
}

Vec3 centerOf(const shared::Quadric& quadric) {
    return Vec3(quadric.center) + Vec3(quadric.centerRest);
}

/// A ray's answers for a convex solid from its largest and its smallest shape.
AllowedAnswers convexAnswers(const Interval& grown, const Interval& shrunk) {
    AllowedAnswers allowed;
    allowed.miss = shrunk.isEmpty() || shrunk.leave <= 0.0L;
    if (grown.isEmpty())
        return allowed;
    const bool surelyCrossed = !shrunk.isEmpty();
    allowed.entry = {grown.enter, surelyCrossed ? shrunk.enter : grown.leave};
    if (grown.enter <= 0.0L)
        allowed.exit = {surelyCrossed ? shrunk.leave : 0.0L, grown.leave};
    return allowed;
}

} // namespace

Line localLine(const shared::Quadric& quadric, const Line& world) {
    return {localDirection(quadric, world.origin - centerOf(quadric)),
            localDirection(quadric, world.direction)};
}

Real reachOf(const shared::Quadric& quadric) {
    const Real along = quadric.kind == shared::kCylinder ? 0.5L * quadric.extent : quadric.extent;
    return std::hypot(Real(quadric.radius), quadric.kind == shared::kSphere ? 0.0L : along);
}

Real roundingScale(const shared::Quadric& quadric, const Line& world, Real t) {
    const Line line{world.origin - centerOf(quadric), world.direction};
    const Real scale = glm::length(line.origin) + reachOf(quadric);
    if (quadric.kind != shared::kCone)
        return scale;
    const Real toApex = t < kInfinity ? glm::length(line.at(t))
                                      : glm::length(glm::cross(line.origin, line.direction)) /
                                            glm::length(line.direction);
    const Real size = reachOf(quadric);
    return scale * std::max(1.0L, size / std::max(toApex, kRoundoff * size));
}

Interval insideQuadric(const shared::Quadric& quadric, const Line& world, Real growth) {
    const Line line = localLine(quadric, world);
    if (quadric.kind == shared::kSphere)
        return insideSphere(line, quadric.radius + growth);
    if (quadric.kind == shared::kCylinder)
        return insideCylinder(line, quadric.radius + growth, 0.5L * quadric.extent + growth);
    return insideCone(line, quadric.extent, quadric.slope, growth);
}

AllowedAnswers allowedAnswers(const shared::Quadric& quadric, const Line& world, Real tolerance) {
    if (quadric.kind == shared::kDisk)
        return diskAnswers(localLine(quadric, world), quadric.radius, tolerance);
    return convexAnswers(insideQuadric(quadric, world, tolerance),
                         insideQuadric(quadric, world, -tolerance));
}

Real firstHit(const shared::Quadric& quadric, const Line& world) {
    if (quadric.kind == shared::kDisk)
        return firstDiskHit(localLine(quadric, world), quadric.radius);
    const Interval inside = insideQuadric(quadric, world, 0.0L);
    const Real t = inside.enter > 0.0L ? inside.enter : inside.leave;
    return inside.isEmpty() || t <= 0.0L ? kInfinity : t;
}

FaceAt faceAt(const shared::Quadric& quadric, const Vec3& world, const Vec3& normal) {
    const Vec3 p = localDirection(quadric, world - centerOf(quadric));
    const Vec3 n = localDirection(quadric, normal);
    const Real radius = std::hypot(p.x, p.z);
    const auto flat = [&](Real distance, const Vec3& local) {
        return FaceAt{distance, glm::normalize(worldDirection(quadric, local)), false, 0.0L};
    };
    const auto curved = [&](Real distance, const Vec3& local) {
        const Real curvature = quadric.kind == shared::kSphere ? glm::length(p) : radius;
        return FaceAt{distance, glm::normalize(worldDirection(quadric, local)), true, curvature};
    };
    const Vec3 outward = radius > 0.0L ? Vec3(p.x / radius, 0.0L, p.z / radius) : Vec3(0.0L);
    switch (quadric.kind) {
    case shared::kSphere:
        return curved(glm::length(p) - quadric.radius, glm::normalize(p));
    case shared::kCylinder:
        if (std::abs(n.y) < 0.5L)
            return curved(radius - quadric.radius, radius > 0.0L ? outward : n);
        return flat(std::abs(p.y) - 0.5L * quadric.extent,
                    Vec3(0.0L, std::copysign(1.0L, n.y), 0.0L));
    case shared::kCone: {
        const Real down = std::copysign(1.0L, Real(quadric.extent));
        const Real k = quadric.slope;
        const Real scale = 1.0L / std::sqrt(1.0L + k * k);
        if (n.y * down > 0.5L)
            return flat(p.y * down - std::abs(Real(quadric.extent)), Vec3(0.0L, down, 0.0L));
        const Vec3 side = radius > 0.0L
                              ? Vec3(outward.x * scale, -down * k * scale, outward.z * scale)
                              : Vec3(0.0L, -down, 0.0L);
        return curved((radius - k * p.y * down) * scale, side);
    }
    default:
        return flat(p.y, Vec3(0.0L, 1.0L, 0.0L));
    }
}

} // namespace calotype::test
