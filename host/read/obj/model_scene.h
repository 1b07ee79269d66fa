#pragma once

#include <string>

#include "read/reader.h"

namespace calotype {

/// A scene with the Wavefront OBJ at `path`: the model on a grey floor, lit by two quads, from
/// above and from the side, and a faint background. The camera looks slightly down, at an angle, so
/// that the whole model is in the picture, square or wider. All sizes are relative to the model's
/// size, so that it does not change the picture. Materials that no MTL file defines are grey, with
/// a warning. Throws SceneError, also for overrides, because there is nothing to change.
SceneAndNotes readModelScene(const std::string& path, const LoadOptions& options);

} // namespace calotype
