#include "support/test_quadrics.h"

#include <glm/geometric.hpp>

#include "math/rotation.h"

namespace calotype::test {
namespace {

void setFrame(shared::Quadric& quadric, const glm::dmat3& rotation) {
    quadric.axisX = glm::vec3(rotation[0]);
    quadric.axisY = glm::vec3(rotation[1]);
    quadric.axisZ = glm::vec3(rotation[2]);
}

void setSize(shared::Quadric& quadric, double scale, double proportion, RandomNumbers& random) {
    quadric.radius = static_cast<float>(scale);
    if (quadric.kind == shared::kCylinder)
        quadric.extent = static_cast<float>(scale * proportion);
    if (quadric.kind == shared::kCone) {
        const double height = random.sign() * scale / proportion;
        quadric.slope = static_cast<float>(proportion);
        quadric.extent = static_cast<float>(height);
        quadric.radius = static_cast<float>(proportion * std::abs(height));
    }
}

glm::dvec3 onCircle(double radius, double y, RandomNumbers& random) {
    const double phi = 2.0 * std::numbers::pi * random.unit();
    return {radius * std::cos(phi), y, radius * std::sin(phi)};
}

LocalPoint onFlatFace(double radius, double y, double outward, RandomNumbers& random) {
    return {onCircle(radius * std::sqrt(random.unit()), y, random), {0.0, outward, 0.0}};
}

LocalPoint onConeSide(const shared::Quadric& cone, RandomNumbers& random) {
    const double y = cone.extent * std::sqrt(random.unit());
    const glm::dvec3 p = onCircle(cone.slope * std::abs(y), y, random);
    const double down = cone.extent < 0.0f ? -1.0 : 1.0;
    const double radius = glm::length(glm::dvec2(p.x, p.z));
    return {p, glm::normalize(glm::dvec3(p.x, -down * cone.slope * radius, p.z))};
}

} // namespace

std::string nameOf(uint32_t quadricKind) {
    constexpr const char* kNames[] = {"Sphere", "Cylinder", "Cone", "Disk"};
    return kNames[quadricKind];
}

std::vector<shared::Quadric> variedQuadrics(uint32_t kind, RandomNumbers& random,
                                            std::optional<double> proportion) {
    std::vector<shared::Quadric> quadrics;
    for (const double scale : {1e-3, 1.0, 1e3}) {
        for (uint32_t i = 0; i < 12; ++i) {
            shared::Quadric quadric{};
            quadric.kind = kind;
            setFrame(quadric, i % 2 == 0 ? glm::dmat3(1.0) : randomRotation(random));
            setSize(quadric, scale, proportion ? *proportion : random.powerOfTen(-1.3, 1.3),
                    random);
            if (i >= 4)
                quadric.center =
                    glm::vec3(random.direction() * (scale * random.powerOfTen(-1.0, 3.0)));
            quadric.id = static_cast<uint32_t>(quadrics.size());
            quadrics.push_back(quadric);
        }
    }
    return quadrics;
}

glm::dmat3 randomRotation(RandomNumbers& random) {
    const glm::dmat3 spin = rotationFromDegrees({0.0, random.between(0.0, 360.0), 0.0});
    return rotationTakingYTo(random.direction()) * spin;
}

glm::dvec3 worldPoint(const shared::Quadric& quadric, const glm::dvec3& local) {
    return glm::dvec3(quadric.center) + local.x * glm::dvec3(quadric.axisX) +
           local.y * glm::dvec3(quadric.axisY) + local.z * glm::dvec3(quadric.axisZ);
}

LocalPoint randomSurfacePoint(const shared::Quadric& quadric, RandomNumbers& random) {
    const double radius = quadric.radius;
    const double halfHeight = 0.5 * quadric.extent;
    switch (quadric.kind) {
    case shared::kSphere: {
        const glm::dvec3 normal = random.direction();
        return {radius * normal, normal};
    }
    case shared::kCylinder: {
        if (random.coin()) {
            const double side = random.sign();
            return onFlatFace(radius, side * halfHeight, side, random);
        }
        const glm::dvec3 p = onCircle(radius, random.between(-halfHeight, halfHeight), random);
        return {p, {p.x / radius, 0.0, p.z / radius}};
    }
    case shared::kCone:
        if (random.coin())
            return onFlatFace(radius, quadric.extent, quadric.extent < 0.0f ? -1.0 : 1.0, random);
        return onConeSide(quadric, random);
    default:
        return onFlatFace(radius, 0.0, 1.0, random);
    }
}

glm::dvec3 localMiddle(const shared::Quadric& quadric) {
    return {0.0, quadric.kind == shared::kCone ? 0.5 * quadric.extent : 0.0, 0.0};
}

double faceHeight(const shared::Quadric& quadric, RandomNumbers& random) {
    if (quadric.kind == shared::kCylinder)
        return random.sign() * 0.5 * quadric.extent;
    return quadric.kind == shared::kCone ? quadric.extent : 0.0;
}

} // namespace calotype::test
