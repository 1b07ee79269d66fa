#pragma once

#include "scene/load_context.h"

namespace calotype {

/// A "mesh": an OBJ file in world space, its faces' materials resolved to Scene::materials.
Mesh readMesh(const JsonObject& object, LoadContext& context);

} // namespace calotype
