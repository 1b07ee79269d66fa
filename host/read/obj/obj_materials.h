#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "read/obj/obj_cache.h"
#include "read/read_context.h"

namespace calotype {

/// Which of an OBJ's materials are needed: one for each of ObjFile::materialNames and, last, one
/// for faces without a material.
using NeededMaterials = std::vector<bool>;

/// All that faces of the OBJ use.
NeededMaterials allMaterials(const ObjFile& obj);

/// Adds the needed materials of the OBJ's MTL files to Scene::materials, each once for each OBJ.
/// Returns an index for each element of `needed`, 0 where it is false. Faces without a material,
/// and with one that no MTL file defines, are a grey of 0.5, the latter with a warning.
std::vector<uint32_t> materialsFromMtl(const ObjFile& obj, const std::string& objPath,
                                       const NeededMaterials& needed, ObjCache& cache,
                                       ReadContext& context);

} // namespace calotype
