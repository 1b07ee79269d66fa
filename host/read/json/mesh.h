#pragma once

#include <vector>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The keys of a "mesh".
std::vector<JsonKey> meshKeys();

/// "material" excludes "materials".
JsonRule meshMaterialRule();

/// A "mesh": an OBJ file, displaced, in world space, with indices of Scene::materials for its
/// faces. Warns if textures are used but texture coordinates are missing.
Mesh readMesh(const JsonObject& object, JsonContext& context);

} // namespace calotype
