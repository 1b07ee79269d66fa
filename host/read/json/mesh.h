#pragma once

#include <vector>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The keys of a "mesh".
std::vector<JsonKey> meshKeys();

/// "material" stands in place of "materials".
JsonRule meshMaterialRule();

/// A "mesh": an OBJ file, displaced and in world space, its faces' materials resolved to
/// Scene::materials. Warns where textures are read but texture coordinates missing.
Mesh readMesh(const JsonObject& object, JsonContext& context);

} // namespace calotype
