#pragma once

#include "scene/scene.h"

namespace calotype {

/// Three bumpy balls of 786,432 triangles together above a floor, under one square lamp; diffuse.
Scene makeBenchScene();

/// The same with a material of every kind, textures, and lamps of every kind.
Scene makeManyMaterialScene();

} // namespace calotype
