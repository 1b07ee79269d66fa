#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/content_hash.h"
#include "base/find_file.h"
#include "base/parallel_for.h"
#include "base/read_file.h"
#include "base/task_pool.h"
#include "base/warnings.h"
#include "read/files_ahead.h"
#include "read/load.h"
#include "read/reader.h"
#include "read/texture_budget.h"
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
    ContentHash hash;               ///< of all data that is read
    std::vector<std::string> files; ///< that are read

    FileFinder finder = {};
    TextureBudget textureBudget = {};

    /// Image files by true path, and images made from them (by path and recipe); nullptr for those
    /// that cannot be read. Each is read once for all textures.
    std::map<std::string, std::shared_ptr<const TexelImage>> images = {};

    FilesAhead<TexelImage> imagesAhead;
    TaskPool tasks{allCores()}; ///< they use nothing of the context

    /// The scene with its hash, and the warnings.
    SceneAndNotes finish() && {
        scene.hash = hash.value();
        return {std::move(scene), std::move(warnings), std::move(files)};
    }

    /// The bytes of a file that the scene names. They belong to the scene's hash, and the file to
    /// those that no output may replace, so files are read by this function and takeAhead only.
    /// Throws SceneError at `where` if it cannot be read.
    std::string read(const std::string& path, const std::string& where) {
        list(path);
        std::string bytes = readFile(path, where);
        hash.add(bytes);
        return bytes;
    }

    /// Starts to read a file on another thread. `decode(bytes, onProgress)` makes its contents, and
    /// must use nothing of the context.
    template <typename Contents, typename Decode>
    void startAhead(const std::string& path, FilesAhead<Contents>& ahead, const Decode& decode) {
        ahead.start(path, tasks, [path, decode](const OnProgress& onProgress) {
            std::string bytes = readFile(path, path);
            auto contents = std::make_shared<const Contents>(decode(bytes, onProgress));
            return typename FilesAhead<Contents>::File{std::move(bytes), std::move(contents)};
        });
    }

    /// The contents of a file that was started in `ahead`; nullptr if it must be read.
    template <typename Contents>
    std::shared_ptr<const Contents> takeAhead(const std::string& path, FilesAhead<Contents>& ahead,
                                              const OnProgress& onProgress = {}) {
        auto file = ahead.take(path, tasks, onProgress);
        if (!file)
            return nullptr;
        list(path);
        hash.add(file->bytes);
        return std::move(file->contents);
    }

    void list(const std::string& path) { files.push_back(path); }

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
