#pragma once

#include <vector>

#include "read/json/json_context.h"
#include "read/json/object.h"
#include "read/obj/obj_mesh.h"

namespace calotype {

/// The keys of a "mesh".
std::vector<JsonKey> meshKeys();

/// "material" excludes "materials".
JsonRule meshMaterialRule();

/// Starts to read the files of the "mesh"es among `shapes`, the scene file's own.
void startMeshFiles(const JsonValue& shapes, JsonContext& context);

/// Reads a "mesh": an OBJ file, displaced, in world space, with indices of Scene::materials for its
/// faces. It is built on another thread: finishObjMesh gives it.
BegunObjMesh readMesh(const JsonObject& object, JsonContext& context);

} // namespace calotype
