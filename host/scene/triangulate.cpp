#include "scene/triangulate.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "base/check.h"

namespace calotype {
namespace {

/// Point-in-ear tests for one polygon: ten thousand ragged corners stay below it.
constexpr size_t kMostTests = 100'000'000;

/// Twice the polygon's area vector (Newell), relative to its first corner against cancellation.
glm::dvec3 areaVector(std::span<const glm::dvec3> polygon) {
    glm::dvec3 sum(0.0);
    for (size_t i = 0; i < polygon.size(); ++i) {
        const glm::dvec3 a = polygon[i] - polygon[0];
        const glm::dvec3 b = polygon[(i + 1) % polygon.size()] - polygon[0];
        sum += glm::dvec3((a.y - b.y) * (a.z + b.z), (a.z - b.z) * (a.x + b.x),
                          (a.x - b.x) * (a.y + b.y));
    }
    return sum;
}

} // namespace

/// Drops the axis along which the polygon is thinnest, so that coordinates stay exact, and orders
/// the other two so that the polygon runs counter-clockwise.
void Triangulator::project(std::span<const glm::dvec3> polygon) {
    const glm::dvec3 normal = areaVector(polygon);
    const glm::dvec3 size = glm::abs(normal);
    const int dropped = size.x > size.y && size.x > size.z ? 0 : (size.y > size.z ? 1 : 2);
    int u = (dropped + 1) % 3;
    int v = (dropped + 2) % 3;
    if (normal[dropped] < 0.0) {
        std::swap(u, v);
    }
    const auto count = static_cast<uint32_t>(polygon.size());
    corners_.resize(count);
    for (uint32_t i = 0; i < count; ++i) {
        // Relative to the first corner, so that far polygons keep their precision.
        const glm::dvec3 p = polygon[i] - polygon[0];
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
    if (reflex && !corners_[corner].reflex) {
        reflex_.push_back(corner);
    }
    corners_[corner].reflex = reflex;
}

bool Triangulator::isEar(uint32_t corner) {
    const Corner& b = corners_[corner];
    testsLeft_ -= std::min(testsLeft_, b.reflex ? 1 : reflex_.size() + 1);
    if (b.reflex || testsLeft_ == 0) {
        return false;
    }
    const Corner& a = corners_[b.previous];
    const Corner& c = corners_[b.next];
    const auto leftOf = [](const Corner& from, const Corner& to, const Corner& p) {
        return (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x) >= 0.0;
    };
    const auto samePlace = [](const Corner& p, const Corner& q) {
        return p.x == q.x && p.y == q.y;
    };
    // Only a reflex corner can reach into an ear first.
    for (const uint32_t index : reflex_) {
        const Corner& p = corners_[index];
        if (!p.reflex || samePlace(p, a) || samePlace(p, b) || samePlace(p, c)) {
            continue;
        }
        if (leftOf(a, b, p) && leftOf(b, c, p) && leftOf(c, a, p)) {
            return false;
        }
    }
    return true;
}

/// Where there is no ear: a corner that can go without loss, or else `corner`.
uint32_t Triangulator::flattestCorner(uint32_t corner, uint32_t left) const {
    uint32_t candidate = corner;
    for (uint32_t i = 0; i < left && testsLeft_ > 0; ++i) {
        if (turn(candidate) == 0.0) {
            return candidate;
        }
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

std::span<const Triangulator::Triangle>
Triangulator::triangulate(std::span<const glm::dvec3> polygon) {
    CALOTYPE_CHECK_LE(3u, polygon.size());
    triangles_.clear();
    reflex_.clear();
    sound_ = true;
    testsLeft_ = kMostTests;
    auto left = static_cast<uint32_t>(polygon.size());
    if (left == 3) {
        triangles_.push_back({0, 1, 2});
        return triangles_;
    }
    project(polygon);
    for (uint32_t i = 0; i < left; ++i) {
        updateReflex(i);
    }
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
    return triangles_;
}

} // namespace calotype
