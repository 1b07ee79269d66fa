#pragma once

#include <functional>
#include <optional>
#include <string>

#include "cli/options.h"
#include "scene/scene.h"
#include "settings/render_settings.h"

namespace calotype {

/// The scene that the options name. `onProgress` hears "loading chair.obj", and the share of it
/// done; what it throws ends the reading. Throws SceneError, like loadScene.
Scene readScene(const SceneOptions& options, const std::optional<PictureSize>& size,
                const std::function<void(const std::string& what, double done)>& onProgress);

/// The scene's warnings, on standard error.
void printWarnings(const Scene& scene);

/// All of the picture, as the scene itself says.
RenderSettings settingsOf(const Scene& scene);

} // namespace calotype
