#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The index in Scene::materials for each of the OBJ's materials and, last, for faces without a
/// material: from the mesh's "material", else its "materials", else the OBJ's MTL files (relative
/// to `objPath`). Throws SceneError for keys that match no face.
std::vector<uint32_t> resolveMeshMaterials(const JsonObject& mesh, const ObjFile& obj,
                                           const std::string& objPath, JsonContext& context);

} // namespace calotype
