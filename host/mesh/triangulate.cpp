#include "mesh/triangulate.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/check.h"

namespace calotype {
namespace {

/// Limit on point-in-ear tests for one polygon: enough for ten thousand irregular corners.
constexpr size_t kMostTests = 100'000'000;

/// Twice the area vector of the polygon (Newell).
glm::dvec3 areaVector(std::span<const glm::dvec3> polygon) {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3& a = polygon[i];
        const glm::dvec3& b = polygon[(i + 1) % polygon.size()];
        sum += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x),
                          (a.x - b.x) * (a.y + b.y));
    }
    return sum;
}

/// How well two triangles that share the edge ab agree: the dot product of their normals.
double agreement(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& right,
                 const glm::dvec3& left) {
    return glm::dot(glm::cross(b - right, a - right), glm::cross(a - left, b - left));
}

} // namespace

/// Scaled by a power of two, so that coordinates stay exact and products do not overflow or
/// underflow.
void Triangulator::moveToOrigin(std::span<const glm::dvec3> polygon) {
    double size = 0.0;
    local_.clear();
    for (const glm::dvec3& p : polygon) {
        const glm::dvec3 fromFirst = p - polygon[0];
        const glm::dvec3 extent = glm::abs(fromFirst);
        size = std::max({size, extent.x, extent.y, extent.z});
        local_.push_back(fromFirst);
    }
    if (size > 0.0) {
        const double scale = std::ldexp(1.0, std::clamp(-std::ilogb(size), -1000, 1000));
        for (glm::dvec3& p : local_)
            p *= scale;
    }
}

/// From corner 0 if possible, else along the diagonal whose triangles agree better.
void Triangulator::cutQuad() {
    const double along02 = agreement(local_[0], local_[2], local_[1], local_[3]);
    const double along13 = agreement(local_[1], local_[3], local_[2], local_[0]);
    if (along02 > 0.0 || along02 >= along13) {
        triangles_.push_back({0, 1, 2});
        triangles_.push_back({0, 2, 3});
    } else {
        triangles_.push_back({0, 1, 3});
        triangles_.push_back({1, 2, 3});
    }
}

/// Drops the axis along which the polygon is thinnest, and orders the other two so that the polygon
/// is counter-clockwise.
void Triangulator::project() {
    const glm::dvec3 normal = areaVector(local_);
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    int u = (dropped + 1) % 3;
    int v = (dropped + 2) % 3;
    if (normal[dropped] < 0.0)
        std::swap(u, v);
    const auto count = static_cast<uint32_t>(local_.size());
    corners_.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        const glm::dvec3& p = local_[i];
        corners_[i] = {p[u], p[v], (i + count - 1) % count, (i + 1) % count, false};
    }
}

/// Twice the signed area of the corner's triangle; positive where the polygon turns left.
double Triangulator::turn(uint32_t corner) const {
    const Corner& b = corners_[corner];
    const Corner& a = corners_[b.previous];
    const Corner& c = corners_[b.next];
    return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

void Triangulator::updateReflex(uint32_t corner) {
    const bool reflex = !(turn(corner) > 0.0);
    if (reflex && !corners_[corner].reflex)
        reflex_.push_back(corner);
    corners_[corner].reflex = reflex;
}

bool Triangulator::isEar(uint32_t corner) {
    const Corner& b = corners_[corner];
    testsLeft_ -= std::min(testsLeft_, b.reflex ? 1 : reflex_.size() + 1);
    if (b.reflex || testsLeft_ == 0)
        return false;
    const Corner& a = corners_[b.previous];
    const Corner& c = corners_[b.next];
    const auto leftOf = [](const Corner& from, const Corner& to, const Corner& p) {
        return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x) >= 0.0;
    };
    const auto samePlace = [](const Corner& p, const Corner& q) {
        return p.x == q.x && p.y == q.y;
    };
    // Only a reflex corner can be inside an ear.
    for (const uint32_t index : reflex_) {
        const Corner& p = corners_[index];
        if (!p.reflex || samePlace(p, a) || samePlace(p, b) || samePlace(p, c))
            continue;
        if (leftOf(a, b, p) && leftOf(b, c, p) && leftOf(c, a, p))
            return false;
    }
    return true;
}

/// If there is no ear: a corner that can be removed without loss, or else `corner`.
uint32_t Triangulator::flattestCorner(uint32_t corner, uint32_t left) const {
    uint32_t candidate = corner;
    for (uint32_t i = 0; i < left && testsLeft_ > 0; ++i) {
        if (turn(candidate) == 0.0)
            return candidate;
        candidate = corners_[candidate].next;
    }
    return corner;
}

void Triangulator::clip(uint32_t corner) {
    Corner& removed = corners_[corner];
    triangles_.push_back({removed.previous, corner, removed.next});
    corners_[removed.previous].next = removed.next;
    corners_[removed.next].previous = removed.previous;
    removed.reflex = false;
    updateReflex(removed.previous);
    updateReflex(removed.next);
}

void Triangulator::clipEars() {
    project();
    auto left = static_cast<uint32_t>(corners_.size());
    for (uint32_t i = 0; i < left; ++i)
        updateReflex(i);
    uint32_t corner = 1; // so that a convex polygon becomes the fan from corner 0
    uint32_t misses = 0;
    while (left > 3) {
        if (!isEar(corner)) {
            if (misses < left && testsLeft_ > 0) {
                ++misses;
                corner = corners_[corner].next;
                continue;
            }
            corner = flattestCorner(corner, left);
            sound_ = sound_ && turn(corner) == 0.0;
        }
        misses = 0;
        const uint32_t next = corners_[corner].next;
        clip(corner);
        --left;
        corner = next;
    }
    const Corner& last = corners_[corner];
    triangles_.push_back({last.previous, corner, last.next});
    sound_ = sound_ && turn(corner) >= 0.0;
}

std::span<const Triangulator::Triangle>
Triangulator::triangulate(std::span<const glm::dvec3> polygon) {
    CALOTYPE_CHECK_LE(3u, polygon.size());
    triangles_.clear();
    reflex_.clear();
    sound_ = true;
    testsLeft_ = kMostTests;
    if (polygon.size() == 3) {
        triangles_.push_back({0, 1, 2});
        return triangles_;
    }
    moveToOrigin(polygon);
    if (polygon.size() == 4)
        cutQuad();
    else
        clipEars();
    return triangles_;
}

} // namespace calotype
