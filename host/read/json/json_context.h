#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "mesh/displacement.h"
#include "read/obj/obj_cache.h"
#include "read/read_context.h"

namespace calotype {

/// Data that the readers of a scene file's parts share.
struct JsonContext : ReadContext {
    JsonContext(const LoadOptions& loadOptions, const std::string& path)
        : ReadContext(loadOptions, path), directory(std::filesystem::path(path).parent_path()) {}

    std::filesystem::path directory;             ///< base of the relative file names in the scene
    std::vector<std::string> textureNames = {};  ///< names of the first elements of Scene::textures
    std::vector<std::string> materialNames = {}; ///< those of Scene::materials
    /// For the first elements of Scene::materials, by index; the others have none.
    std::vector<std::optional<Displacement>> displacements = {};
    ObjCache objs = {};
};

} // namespace calotype
