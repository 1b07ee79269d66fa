#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The Scene::materials index for each of the OBJ's materials, and, last, for faces without
/// one: by the mesh's "material", else its "materials", else the OBJ's MTL files (read from
/// beside `objPath`). Throws SceneError for keys that fit no face, for faces that no key fits, and
/// for materials that no MTL file defines.
std::vector<uint32_t> resolveMeshMaterials(const JsonObject& mesh, const ObjFile& obj,
                                           const std::string& objPath, JsonContext& context);

} // namespace calotype
