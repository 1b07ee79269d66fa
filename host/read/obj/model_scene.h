#pragma once

#include <string>

#include "read/reader.h"

namespace calotype {

/// A scene around the Wavefront OBJ at `path`: the model on a grey floor, lit by two quads from
/// above and the side and a faint background, seen at an angle from slightly above so that all of
/// it is in the picture, be that square or wider. All sizes follow the model's, so that the picture
/// does not depend on them. Materials that no MTL file defines are grey, with a warning. Throws
/// SceneError, also for overrides, which have nothing to change here.
SceneAndNotes readModelScene(const std::string& path, const LoadOptions& options);

} // namespace calotype
