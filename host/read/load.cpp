#include "read/load.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/lowercase.h"
#include "check/validate.h"
#include "read/json/scene.h"
#include "read/reader.h"

namespace calotype {
namespace {

SceneAndNotes readScene(const std::string& path, const LoadOptions& options) {
    const std::string extension = lowercase(std::filesystem::path(path).extension().string());
    const auto readers = sceneReaders();
    const auto found = std::ranges::find(readers, extension, &SceneReader::extension);
    return found != readers.end() ? found->read(path, options) : readJsonScene(path, options);
}

} // namespace

LoadedScene loadScene(const std::string& path, const LoadOptions& options) {
    auto [scene, warnings, files] = readScene(path, options);
    if (options.size) {
        scene.film.width = options.size->width;
        scene.film.height = options.size->height;
    }
    validate(scene, warnings);
    scene.warnings = warnings.sentences();
    return LoadedScene(std::move(scene), std::move(files));
}

} // namespace calotype
