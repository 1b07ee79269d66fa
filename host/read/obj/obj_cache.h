#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "read/obj/obj_file.h"

namespace calotype {

/// What has been read of OBJ files, by their paths: each is read once, however many meshes name it.
struct ObjCache {
    std::map<std::string, std::shared_ptr<const ObjFile>> files;
    std::map<std::string, std::vector<uint32_t>> mtlMaterials; ///< see materialsFromMtl
};

} // namespace calotype
