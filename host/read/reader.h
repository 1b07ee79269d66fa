#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/warnings.h"
#include "read/load.h"
#include "scene/scene.h"

namespace calotype {

/// The result of a reader: a scene that is not validated yet, notes about the file, and the paths
/// of all files that were read.
struct SceneAndNotes {
    Scene scene;
    Warnings notes;
    std::vector<std::string> files;
};

/// One file format for scenes.
struct SceneReader {
    std::string_view extension; ///< in lower case, such as ".obj"
    /// Throws SceneError with the place of the first mistake.
    SceneAndNotes (*read)(const std::string& path, const LoadOptions& options);
};

/// The list of readers. A new file format needs a folder in read/ and a row here. Files with any
/// other extension are read as scene files (JSON).
std::span<const SceneReader> sceneReaders();

} // namespace calotype
