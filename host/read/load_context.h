#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/content_hash.h"
#include "base/warnings.h"
#include "mesh/displacement.h"
#include "read/load.h"
#include "read/obj/obj_file.h"
#include "read/reader.h"
#include "scene/scene.h"

namespace calotype {

/// What the readers of one scene file share: what is made, and what is looked up on the way.
struct LoadContext {
    LoadContext(const LoadOptions& loadOptions, const std::string& path)
        : options(loadOptions), directory(std::filesystem::path(path).parent_path()) {
        scene.place = path;
    }

    /// The scene with its hash, and the warnings.
    SceneAndNotes finish() && {
        scene.hash = hash.value();
        return {std::move(scene), std::move(warnings)};
    }

    const LoadOptions& options;
    std::filesystem::path directory; ///< that file names in the scene are relative to
    /// Faces whose material no MTL file defines are grey, with a warning, rather than an error.
    bool toleratesUndefinedMaterials = false;

    Scene scene;
    Warnings warnings;
    ContentHash hash;
    std::vector<std::string> textureNames;  ///< of the scene file: the first of Scene::textures
    std::vector<std::string> materialNames; ///< of the scene file: the first of Scene::materials

    /// OBJ files by path, each read once however many meshes name it.
    std::map<std::string, std::shared_ptr<const ObjFile>> objFiles;
    /// Image files by path, and what is made of them (by path and recipe), each read once however
    /// many textures name it.
    std::map<std::string, std::shared_ptr<const TexelImage>> images;
    /// What materialsFromMtl returned, by OBJ path.
    std::map<std::string, std::vector<uint32_t>> mtlMaterials;
    /// Of the first of Scene::materials, by their index; the others have none.
    std::vector<std::optional<Displacement>> displacements = {};

    uint32_t addMaterial(Material material) {
        scene.materials.push_back(std::move(material));
        return static_cast<uint32_t>(scene.materials.size() - 1);
    }

    uint32_t addTexture(Texture texture) {
        scene.textures.push_back(std::move(texture));
        return static_cast<uint32_t>(scene.textures.size() - 1);
    }

    /// Adds the sentence "WHERE: MESSAGE", once.
    void warn(const std::string& where, const std::string& message) {
        warnings.add(where, message);
    }

    void progress(const std::filesystem::path& file, double done) const {
        if (options.onProgress) {
            options.onProgress(file.filename().string(), done);
        }
    }
};

} // namespace calotype
