#pragma once

#include <string>

#include "read/reader.h"

namespace calotype {

/// Reads a scene file (scenes/scene.schema.json describes the format).
SceneAndNotes readJsonScene(const std::string& path, const LoadOptions& options);

/// The JSON Schema (draft 07) of scene files, from the same tables as the reader.
std::string sceneSchema();

} // namespace calotype
