#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// The points of a model that a picture of it must show.
struct FramedPoints {
    std::vector<glm::dvec3> points;
    /// How many times larger the largest parts are than all others together; 1 if they are not many
    /// times larger.
    double ratio = 1.0;
    bool leavesOutLargest = false; ///< the points are those of the other parts
};

/// All positions of the mesh that triangles use; but without its largest connected parts if they
/// are many times larger than all others together and look like surroundings: flat like a floor, or
/// of less than half of the triangles like a simple room. Others must not be flat themselves.
FramedPoints framedPoints(const Mesh& mesh);

} // namespace calotype
