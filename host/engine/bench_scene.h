#pragma once

#include "scene/scene.h"

namespace calotype {

/// Three bumpy balls of 786,432 triangles in total above a floor, under one square light; diffuse.
Scene makeBenchScene();

/// The same with a material of every kind, textures, and lights of every kind.
Scene makeManyMaterialScene();

} // namespace calotype
