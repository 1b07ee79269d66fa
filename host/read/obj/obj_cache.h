#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "read/files_ahead.h"
#include "read/obj/mtl_library.h"
#include "read/obj/mtl_maps.h"
#include "read/obj/obj_file.h"

namespace calotype {

/// The OBJ files that have been read, and their MTL files: each is read once for all meshes.
struct ObjCache {
    /// What has been made of the MTL files of one OBJ.
    struct Materials {
        std::unique_ptr<const MtlLibrary> library;
        std::vector<std::optional<uint32_t>> indices; ///< see materialsFromMtl
    };
    std::map<std::string, std::shared_ptr<const ObjFile>> files; ///< by true path
    std::map<std::string, Materials> materials;                  ///< by the OBJ's path
    FilesAhead<ObjFile> ahead;
    MtlFiles mtlFiles;
    MtlMapCache maps;
};

} // namespace calotype
