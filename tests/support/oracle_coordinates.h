#pragma once

#include <glm/vec2.hpp>

#include "shared/scene_structs.h"
#include "support/oracle_line.h"

namespace calotype::test {

/// The texture coordinates that the scene format gives a point of a quadric, in its frame, as
/// functions of space about the surface: u in [0, 1) around an axis.
glm::dvec2 oracleCoordinates(const shared::Quadric& quadric, bool isOnFlatFace,
                             const glm::dvec3& p);

/// Whether a point in the quadric's frame lies nearer to a cap, a base or the disk's plane than to
/// a curved face, and how much nearer.
struct NearestFace {
    bool isFlat;
    double margin;
};
NearestFace nearestFace(const shared::Quadric& quadric, const glm::dvec3& p);

/// A point of the world in the quadric's frame.
glm::dvec3 localPoint(const shared::Quadric& quadric, const glm::dvec3& world);

} // namespace calotype::test
