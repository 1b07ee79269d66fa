#pragma once

#include "read/load_context.h"

namespace calotype {

/// A "mesh": an OBJ file, displaced and in world space, its faces' materials resolved to
/// Scene::materials. Warns where textures are read but texture coordinates missing.
Mesh readMesh(const JsonObject& object, LoadContext& context);

} // namespace calotype
