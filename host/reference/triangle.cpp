#include "reference/triangle.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/rounding.h"

// A ray hits the triangle if, projected along the ray, it is inside the outline. No ray passes
// between triangles that share an edge or a corner: a shared corner has one projection, rounded
// once, and the side of a projected edge is computed exactly; the edge itself counts to both sides.
// So the projected triangles are again a closed mesh, in exact arithmetic.

namespace calotype::reference {
namespace {

/// ax by - ay bx, with exact sign. Rounding keeps the order of the two products; if they are
/// rounded to the same number, the rounding errors decide.
double exactCross(const glm::dvec3& a, const glm::dvec3& b) {
    const double positive = a.x * b.y;
    const double negative = a.y * b.x;
    if (positive != negative)
        return positive - negative;
    return std::fma(a.x, b.y, -positive) - std::fma(a.y, b.x, -negative);
}

double largestComponent(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Two edges from the first corner, scaled to about one so that products cannot over- or underflow.
struct ScaledEdges {
    explicit ScaledEdges(const Corners& corners)
        : toSecond(corners[1] - corners[0]), toThird(corners[2] - corners[0]),
          size(std::max(largestComponent(toSecond), largestComponent(toThird))) {
        toSecond /= size;
        toThird /= size;
    }

    glm::dvec3 toSecond;
    glm::dvec3 toThird;
    double size;
};

/// Whether the point is in the plane, up to rounding: the volume of the point and the triangle is
/// negligible compared with the sum of the absolute values of its terms, or the distance to the
/// plane is negligible compared with those of the corners, from which a hit's distance is computed.
bool isInPlane(const Corners& corners, const glm::dvec3& point) {
    const ScaledEdges edges(corners);
    const glm::dvec3 a = edges.toSecond;
    const glm::dvec3 b = edges.toThird;
    const glm::dvec3 p = point - corners[0];
    const glm::dvec3 terms(std::abs(a.y * b.z) + std::abs(a.z * b.y),
                           std::abs(a.z * b.x) + std::abs(a.x * b.z),
                           std::abs(a.x * b.y) + std::abs(a.y * b.x));
    const glm::dvec3 normal = glm::cross(a, b);
    return std::abs(glm::dot(normal, p)) <=
           kSurfaceTolerance *
               (glm::dot(terms, glm::abs(p)) + glm::length(normal) * (glm::length(p) + edges.size));
}

} // namespace

View::View(const Ray& ray) : origin_(ray.origin), forward_(ray.direction) {
    const glm::dvec3 along = glm::abs(forward_);
    const glm::dvec3 leastAlong = along.x <= along.y && along.x <= along.z ? glm::dvec3(1, 0, 0)
                                  : along.y <= along.z                     ? glm::dvec3(0, 1, 0)
                                                                           : glm::dvec3(0, 0, 1);
    right_ = glm::normalize(glm::cross(forward_, leastAlong));
    up_ = glm::cross(right_, forward_);
}

glm::dvec3 View::operator()(const glm::dvec3& point) const {
    const glm::dvec3 p = point - origin_;
    return {glm::dot(p, right_), glm::dot(p, up_), glm::dot(p, forward_)};
}

std::optional<TriangleHit> intersect(const Corners& corners, const View& view) {
    const glm::dvec3 a = view(corners[0]);
    const glm::dvec3 b = view(corners[1]);
    const glm::dvec3 c = view(corners[2]);
    // Twice the areas of the ray with each edge: the weights of the opposite corners.
    const glm::dvec3 areas(exactCross(b, c), exactCross(c, a), exactCross(a, b));
    const bool isFront = areas.x >= 0.0 && areas.y >= 0.0 && areas.z >= 0.0;
    const bool isBack = areas.x <= 0.0 && areas.y <= 0.0 && areas.z <= 0.0;
    const double sum = areas.x + areas.y + areas.z;
    if (!(isFront || isBack) || sum == 0.0)
        return std::nullopt;
    const glm::dvec3 weights = areas / sum;
    const double t = weights.x * a.z + weights.y * b.z + weights.z * c.z;
    if (!(t > 0.0) || isInPlane(corners, view.origin()))
        return std::nullopt;
    return TriangleHit{t, weights};
}

glm::dvec3 normalOf(const Corners& corners) {
    const ScaledEdges edges(corners);
    return glm::normalize(glm::cross(edges.toSecond, edges.toThird));
}

glm::dvec3 weightsAt(const Corners& corners, const glm::dvec3& point) {
    const ScaledEdges edges(corners);
    const glm::dvec3 p = (point - corners[0]) / edges.size;
    const glm::dvec3 normal = glm::cross(edges.toSecond, edges.toThird);
    const double whole = glm::dot(normal, normal);
    const double second = glm::dot(glm::cross(p, edges.toThird), normal) / whole;
    const double third = glm::dot(glm::cross(edges.toSecond, p), normal) / whole;
    return {1.0 - second - third, second, third};
}

double areaOf(const Corners& corners) {
    const ScaledEdges edges(corners);
    return 0.5 * edges.size * edges.size * glm::length(glm::cross(edges.toSecond, edges.toThird));
}

} // namespace calotype::reference
