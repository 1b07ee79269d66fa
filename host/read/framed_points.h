#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"

namespace calotype {

/// The points of a model that a picture of it must show.
struct FramedPoints {
    std::vector<glm::dvec3> points;
    double scaleOfTheRest = 1.0; ///< how many times larger than them the largest part left out is
};

/// All positions of the mesh; but without its largest connected parts if they are simple and many
/// times larger than all others together, such as a floor or a sky around the model.
FramedPoints framedPoints(const Mesh& mesh);

} // namespace calotype
