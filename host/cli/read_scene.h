#pragma once

#include <functional>
#include <string>

#include "cli/options.h"
#include "scene/scene.h"

namespace calotype {

/// The scene that the options name, in the size that the settings give, if they do. `onProgress` is
/// told "loading chair.obj", and the share of it done; what it throws ends the reading. Throws
/// SceneError, like loadScene.
Scene readScene(const SceneOptions& options, const GivenSettings& settings,
                const std::function<void(const std::string& what, double done)>& onProgress);

/// On standard error.
void printWarning(const std::string& warning);

/// The scene's warnings, likewise.
void printWarnings(const Scene& scene);

} // namespace calotype
