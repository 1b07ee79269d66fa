#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "read/json/object.h"
#include "read/load_context.h"

namespace calotype {

/// The Scene::materials index for each of the OBJ's materials, and, last, for faces that bear
/// none: by the mesh's "material", else its "materials", else the OBJ's MTL files (read from
/// beside `objPath`). Throws SceneError for keys that fit no face, for faces that no key fits, and
/// for materials that no MTL file defines.
std::vector<uint32_t> resolveMeshMaterials(const JsonObject& mesh, const ObjFile& obj,
                                           const std::string& objPath, LoadContext& context);

} // namespace calotype
