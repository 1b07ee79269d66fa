#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "read/obj/obj_cache.h"
#include "read/read_context.h"

namespace calotype {

/// What to do with a material that no MTL file defines.
enum class UndefinedMaterials : uint8_t {
    Fail, ///< throw SceneError at "OBJPATH:LINE"
    Grey, ///< use the grey of faces without a material, with a warning
};

/// Adds the materials of the OBJ's MTL files to Scene::materials, once for each OBJ. Returns one
/// index for each of ObjFile::materialNames and, last, one for faces without a material, which are
/// a grey of 0.5.
std::vector<uint32_t> materialsFromMtl(const ObjFile& obj, const std::string& objPath,
                                       UndefinedMaterials undefined, ObjCache& cache,
                                       ReadContext& context);

} // namespace calotype
