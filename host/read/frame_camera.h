#pragma once

#include <span>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// Moves the camera, whose directions and field of view stay, to the nearest place from where all
/// `points` lie in the middle `share` of a square picture, centred; at least `clearance` before
/// them. Focuses on `focus`.
void frameCamera(Camera& camera, std::span<const glm::dvec3> points, double share, double clearance,
                 const glm::dvec3& focus);

} // namespace calotype
