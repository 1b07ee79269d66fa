#pragma once

#include "scene/scene.h"

namespace calotype::test {

/// The scene with every length multiplied by `scale` and then everything moved by `offset`, camera
/// and lens included. Radiances stay, so the picture should too.
Scene scaledAndMoved(Scene scene, double scale, const glm::dvec3& offset);

/// Every kind of primitive, each also as a light, a mesh with smooth normals, a ball and a cube of
/// glass, a faint background, a thin lens. Some ten metres in size.
Scene everyShape();

} // namespace calotype::test
