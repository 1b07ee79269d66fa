#pragma once

#include <cstddef>
#include <string>

#include "scene/scene.h"

namespace calotype {

/// The place of a shape, for messages; if it has none (in scenes made in memory), "SCENE:
/// /shapes/INDEX".
std::string placeOfShape(const Scene& scene, size_t index);
std::string placeOf(const Scene& scene, const Shape& shape);

/// The same for a material: its place, or "SCENE: material "NAME"".
std::string placeOfMaterial(const Scene& scene, size_t index);

/// "SCENE: POINTER", for parts that a scene has only once, such as "/camera/fov".
std::string placeOf(const Scene& scene, const std::string& pointer);

} // namespace calotype
