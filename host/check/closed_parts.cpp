#include "check/closed_parts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <glm/geometric.hpp>

#include "mesh/distinct_values.h"

namespace calotype {
namespace {

/// A forest of merged sets: each number leads to that of its set.
class MergedSets {
public:
    uint32_t setOf(uint32_t number) {
        while (number >= parent_.size())
            parent_.push_back(static_cast<uint32_t>(parent_.size()));
        while (parent_[number] != number)
            number = parent_[number] = parent_[parent_[number]];
        return number;
    }

    void merge(uint32_t a, uint32_t b) { parent_[setOf(a)] = setOf(b); }

private:
    std::vector<uint32_t> parent_;
};

/// A random number for each pair (the finalizer of SplitMix64).
uint64_t hashOfPair(uint32_t a, uint32_t b) {
    uint64_t hash = (uint64_t{a} << 32 | b) + 0x9e3779b97f4a7c15u;
    hash = (hash ^ hash >> 30) * 0xbf58476d1ce4e5b9u;
    hash = (hash ^ hash >> 27) * 0x94d049bb133111ebu;
    return hash ^ hash >> 31;
}

/// Sums of random numbers, one for each edge. A sum is zero if all edges cancel, and otherwise with
/// a probability of 2^-64.
struct EdgeSums {
    uint64_t oriented = 0; ///< an edge run the other way is subtracted
    uint64_t parity = 0;   ///< an edge that is used twice cancels

    void add(uint32_t from, uint32_t to) {
        const uint64_t hash = hashOfPair(std::min(from, to), std::max(from, to));
        oriented += from < to ? hash : 0 - hash;
        parity ^= hash;
    }
};

/// The measures are relative to one of the part's corners, so that they keep their digits.
void measure(MeshPart& part) {
    const auto& positions = part.mesh->positions;
    const glm::dvec3 origin = positions[part.mesh->triangles[part.triangles[0]].position[0]];
    for (const uint32_t index : part.triangles) {
        glm::dvec3 corner[3];
        for (int k = 0; k < 3; ++k) {
            const glm::dvec3& position = positions[part.mesh->triangles[index].position[k]];
            part.bounds.extend(position);
            corner[k] = position - origin;
        }
        const glm::dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        part.area += 0.5 * glm::length(normal);
        part.volume += glm::dot(corner[0], normal) / 6.0;
    }
}

} // namespace

std::vector<MeshPart> partsOf(const Mesh& mesh, const std::vector<bool>& isChosen) {
    constexpr uint32_t kNone = ~0u;
    DistinctValues<glm::dvec3> distinct;
    MergedSets sets;
    std::vector<uint32_t> place(mesh.positions.size(), kNone);
    for (const Mesh::Triangle& triangle : mesh.triangles) {
        if (!isChosen[triangle.material])
            continue;
        for (const uint32_t corner : triangle.position) {
            if (place[corner] == kNone)
                place[corner] = distinct.add(mesh.positions[corner]);
            sets.merge(place[corner], place[triangle.position[0]]);
        }
    }
    std::vector<uint32_t> partOfSet(distinct.values().size(), kNone);
    std::vector<MeshPart> parts;
    std::vector<EdgeSums> sums;
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Mesh::Triangle& triangle = mesh.triangles[i];
        if (!isChosen[triangle.material])
            continue;
        uint32_t& part = partOfSet[sets.setOf(place[triangle.position[0]])];
        if (part == kNone) {
            part = static_cast<uint32_t>(parts.size());
            parts.emplace_back().mesh = &mesh;
            sums.emplace_back();
        }
        parts[part].triangles.push_back(i);
        for (int k = 0; k < 3; ++k)
            sums[part].add(place[triangle.position[k]], place[triangle.position[(k + 1) % 3]]);
    }
    for (size_t i = 0; i < parts.size(); ++i) {
        parts[i].isClosed = sums[i].parity == 0;
        parts[i].isOriented = sums[i].oriented == 0;
        measure(parts[i]);
    }
    return parts;
}

/// The sum of the solid angles of the triangles (Van Oosterom and Strackee 1983).
double windingNumber(const MeshPart& part, const glm::dvec3& point) {
    double sum = 0.0;
    for (const uint32_t index : part.triangles) {
        const auto& triangle = part.mesh->triangles[index];
        const glm::dvec3 a = part.mesh->positions[triangle.position[0]] - point;
        const glm::dvec3 b = part.mesh->positions[triangle.position[1]] - point;
        const glm::dvec3 c = part.mesh->positions[triangle.position[2]] - point;
        const double lengthA = glm::length(a);
        const double lengthB = glm::length(b);
        const double lengthC = glm::length(c);
        sum += 2.0 * std::atan2(glm::dot(a, glm::cross(b, c)),
                                lengthA * lengthB * lengthC + glm::dot(a, b) * lengthC +
                                    glm::dot(b, c) * lengthA + glm::dot(c, a) * lengthB);
    }
    return sum / (4.0 * std::numbers::pi);
}

} // namespace calotype
