#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// Moves the camera, without changing its directions and field of view, to the nearest position
/// from which all `points` are in the middle `share` of a square picture, centred, and at least
/// `clearance` in front of the camera. Focuses on `focus`.
void frameCamera(Camera& camera, std::span<const glm::dvec3> points, double share, double clearance,
                 const glm::dvec3& focus);

} // namespace calotype
