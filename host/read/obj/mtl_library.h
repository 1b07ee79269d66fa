#pragma once

#include "read/load_context.h"

namespace calotype {

/// Adds to Scene::materials what the OBJ's MTL files say of its materials, once for each OBJ. One
/// index for each of ObjFile::materialNames and, last, one for faces without a material, which are
/// a grey of 0.5. Throws SceneError at "OBJPATH:LINE" where a material is in none of the files that
/// can be read, unless the context tolerates that: then it is the same grey, with a warning.
std::vector<uint32_t> materialsFromMtl(const ObjFile& obj, const std::string& objPath,
                                       LoadContext& context);

} // namespace calotype
