#pragma once

#include <string>

#include "scene/load_context.h"

namespace calotype {

/// Warns, once the shapes are read, where the camera's pixels are so small or its lens is so wide
/// that single precision does not tell the rays of neighbouring pixels apart. `path` is the scene
/// file's.
void warnOfFineView(LoadContext& context, const std::string& path);

} // namespace calotype
