#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/displacement.h"
#include "read/obj/obj_cache.h"
#include "read/read_context.h"

namespace calotype {

/// What the readers of a scene file's parts share.
struct JsonContext : ReadContext {
    JsonContext(const LoadOptions& loadOptions, const std::string& path)
        : ReadContext(loadOptions, path), directory(std::filesystem::path(path).parent_path()) {}

    std::filesystem::path directory;             ///< that file names in the scene are relative to
    std::vector<std::string> textureNames = {};  ///< of the first of Scene::textures
    std::vector<std::string> materialNames = {}; ///< of the first of Scene::materials
    /// Of the first of Scene::materials, by their index; the others have none.
    std::vector<std::optional<Displacement>> displacements = {};
    ObjCache objs = {};
};

} // namespace calotype
