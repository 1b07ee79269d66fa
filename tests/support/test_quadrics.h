#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>

#include "shared/scene_structs.h"
#include "support/random_numbers.h"

namespace calotype::test {

inline constexpr std::array kAllQuadricKinds = {shared::kSphere, shared::kCylinder, shared::kCone,
                                                shared::kDisk};

std::string nameOf(uint32_t quadricKind);

/// Quadrics of one kind at the scales 1e-3, 1 and 1e3, in the world's frame and in random ones, at
/// the origin and up to 1000 radii away from it. The `proportion` of a cylinder is its height over
/// its radius, that of a cone its slope; by default each has its own, from 0.05 to 20.
std::vector<shared::Quadric> variedQuadrics(uint32_t kind, RandomNumbers& random,
                                            std::optional<double> proportion = std::nullopt);

/// A random rotation.
glm::dmat3 randomRotation(RandomNumbers& random);

/// A point of the quadric's frame in the world.
glm::dvec3 worldPoint(const shared::Quadric& quadric, const glm::dvec3& local);

/// A random point in the quadric's frame on its surface, with its outward normal.
struct LocalPoint {
    glm::dvec3 position;
    glm::dvec3 normal;
};
LocalPoint randomSurfacePoint(const shared::Quadric& quadric, RandomNumbers& random);

/// The middle of the quadric, in its frame.
glm::dvec3 localMiddle(const shared::Quadric& quadric);

/// Height in the quadric's frame of a flat face: a cap, the base, the disk's plane; 0 for a sphere.
double faceHeight(const shared::Quadric& quadric, RandomNumbers& random);

} // namespace calotype::test
