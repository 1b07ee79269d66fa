#include "support/oracle_coordinates.h"

#include <cmath>
#include <numbers>

namespace calotype::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// atan2(z, x) / 2 pi mod 1.
double turnsAboutAxis(const glm::dvec3& p) {
    const double turns = std::atan2(p.z, p.x) / (2.0 * kPi);
    return turns - std::floor(turns);
}

} // namespace

glm::dvec2 oracleCoordinates(const shared::Quadric& quadric, bool isOnFlatFace,
                             const glm::dvec3& p) {
    const double diameter = 2.0 * quadric.radius;
    if (isOnFlatFace)
        return {0.5 + p.x / diameter, 0.5 + p.z / diameter};
    const double height = quadric.extent;
    switch (quadric.kind) {
    case shared::kSphere:
        return {turnsAboutAxis(p), 1.0 - std::acos(p.y / glm::length(p)) / kPi};
    case shared::kCylinder:
        return {turnsAboutAxis(p), (p.y + 0.5 * height) / height};
    default: // a cone from y = 0 to its height, whichever is lower
        return {turnsAboutAxis(p), (p.y - std::min(height, 0.0)) / std::abs(height)};
    }
}

NearestFace nearestFace(const shared::Quadric& quadric, const glm::dvec3& p) {
    const double radius = std::hypot(p.x, p.z);
    double toFlat = 0.0;
    double toCurved = 0.0;
    switch (quadric.kind) {
    case shared::kSphere:
        return {false, HUGE_VAL};
    case shared::kDisk:
        return {true, HUGE_VAL};
    case shared::kCylinder:
        toFlat = std::abs(std::abs(p.y) - 0.5 * quadric.extent);
        toCurved = std::abs(radius - quadric.radius);
        break;
    default:
        toFlat = std::abs(p.y - quadric.extent);
        toCurved =
            std::abs(radius - quadric.slope * std::abs(p.y)) / std::hypot(1.0, quadric.slope);
    }
    return {toFlat < toCurved, std::abs(toFlat - toCurved)};
}

glm::dvec3 localPoint(const shared::Quadric& quadric, const glm::dvec3& world) {
    const glm::dvec3 p = world - glm::dvec3(quadric.center);
    return {glm::dot(p, glm::dvec3(quadric.axisX)), glm::dot(p, glm::dvec3(quadric.axisY)),
            glm::dot(p, glm::dvec3(quadric.axisZ))};
}

} // namespace calotype::test
