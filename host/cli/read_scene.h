#pragma once

#include <functional>
#include <string>

#include "cli/options.h"
#include "read/load.h"
#include "scene/scene.h"

namespace calotype {

/// The scene that the options name, in the size that the settings give, if any. Images that the
/// device cannot hold are refused before they are decoded. `onProgress` is
/// called with a step such as "loading chair.obj", and its share done in [0, 1]; it may throw to
/// end the reading. Throws like loadScene.
LoadedScene readScene(const SceneOptions& options, const GivenSettings& settings,
                      const DeviceOptions& device,
                      const std::function<void(const std::string& what, double done)>& onProgress);

/// Prints on standard error.
void printWarning(const std::string& warning);

/// Prints all warnings of the scene.
void printWarnings(const Scene& scene);

} // namespace calotype
