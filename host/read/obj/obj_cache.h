#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "read/obj/obj_file.h"

namespace calotype {

/// The OBJ files that have been read, by path: each is read once for all its meshes.
struct ObjCache {
    std::map<std::string, std::shared_ptr<const ObjFile>> files;
    std::map<std::string, std::vector<uint32_t>> mtlMaterials; ///< see materialsFromMtl
};

} // namespace calotype
