#include "support/oracle_triangle.h"

#include <cmath>

namespace calotype::test {
namespace {

Real cross2(const Vec2& a, const Vec2& b) { return a.x * b.y - a.y * b.x; }

/// Two unit vectors across a unit vector.
void perpendiculars(const Vec3& w, Vec3& u, Vec3& v) {
    const Vec3 helper = std::abs(w.x) < 0.6L ? Vec3(1.0L, 0.0L, 0.0L) : Vec3(0.0L, 1.0L, 0.0L);
    u = glm::normalize(glm::cross(w, helper));
    v = glm::cross(w, u);
}

} // namespace

TriangleCrossing crossTriangle(const shared::Triangle& triangle, const Line& line) {
    const Real length = glm::length(line.direction);
    const Vec3 along = line.direction / length;
    Vec3 u;
    Vec3 v;
    perpendiculars(along, u, v);
    Vec2 flat[3];
    Real depth[3];
    TriangleCrossing crossing;
    const glm::vec3 corners[3] = {triangle.v0, triangle.v1, triangle.v2};
    for (int i = 0; i < 3; ++i) {
        const Vec3 p = Vec3(corners[i]) - line.origin;
        flat[i] = {glm::dot(p, u), glm::dot(p, v)};
        depth[i] = glm::dot(p, along);
        crossing.reach = std::max(crossing.reach, glm::length(p));
    }
    const Real twiceArea = cross2(flat[1] - flat[0], flat[2] - flat[0]);
    if (twiceArea == 0.0L)
        return crossing;
    Real weights[3];
    Real longest = 0.0L;
    crossing.insideBy = kInfinity;
    for (int i = 0; i < 3; ++i) {
        const Vec2 from = flat[(i + 1) % 3];
        const Vec2 to = flat[(i + 2) % 3];
        const Real edge = glm::length(to - from);
        weights[i] = cross2(from, to) / twiceArea;
        longest = std::max(longest, edge);
        crossing.insideBy = std::min(crossing.insideBy, weights[i] * std::abs(twiceArea) / edge);
    }
    const auto [nearest, farthest] = std::minmax({depth[0], depth[1], depth[2]});
    crossing.magnification =
        std::max(1.0L, (farthest - nearest + longest) * longest / std::abs(twiceArea));
    crossing.t = (weights[0] * depth[0] + weights[1] * depth[1] + weights[2] * depth[2]) / length;
    crossing.barycentrics = {weights[1], weights[2]};
    return crossing;
}

} // namespace calotype::test
