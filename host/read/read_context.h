#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>

#include "base/content_hash.h"
#include "base/warnings.h"
#include "read/load.h"
#include "read/reader.h"
#include "scene/scene.h"

namespace calotype {

/// The result of a reader of any format, and data that its parts share while they read one file.
struct ReadContext {
    ReadContext(const LoadOptions& loadOptions, const std::string& path) : options(loadOptions) {
        scene.place = path;
    }

    const LoadOptions& options;
    Scene scene;
    Warnings warnings;
    ContentHash hash; ///< of all data that is read

    /// Image files by path, and images made from them (by path and recipe). Each is read once for
    /// all textures.
    std::map<std::string, std::shared_ptr<const TexelImage>> images = {};

    /// The scene with its hash, and the warnings.
    SceneAndNotes finish() && {
        scene.hash = hash.value();
        return {std::move(scene), std::move(warnings)};
    }

    uint32_t addMaterial(Material material) {
        scene.materials.push_back(std::move(material));
        return static_cast<uint32_t>(scene.materials.size() - 1);
    }

    uint32_t addTexture(Texture texture) {
        scene.textures.push_back(std::move(texture));
        return static_cast<uint32_t>(scene.textures.size() - 1);
    }

    /// Adds a warning, see Warnings::add.
    void warn(const std::string& where, const std::string& message, const std::string& kind = "") {
        warnings.add(where, message, kind);
    }

    void progress(const std::filesystem::path& file, double done) const {
        if (options.onProgress)
            options.onProgress(file.filename().string(), done);
    }
};

} // namespace calotype
