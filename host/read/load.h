#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "read/view_options.h"
#include "scene/scene.h"
#include "settings/picture_size.h"

namespace calotype {

/// One `--set POINTER=VALUE` of the command line. The value is JSON, or else a string.
struct SceneOverride {
    std::string pointer; ///< RFC 6901, such as "/materials/gold/roughness"
    std::string value;
};

/// What to do if the image file of a texture cannot be found.
enum class MissingTextures : uint8_t { Fail, Warn }; ///< Warn: show magenta instead

struct LoadOptions {
    MissingTextures missingTextures = MissingTextures::Fail;
    std::vector<SceneOverride> overrides;
    std::optional<PictureSize> size; ///< replaces that of the scene's film
    ViewOptions view;
    /// Called from time to time with a file name such as "chair.obj", and the share done in [0, 1].
    std::function<void(const std::string& what, double done)> onProgress;
};

/// A scene that loadScene has read and checked. Converts to a Scene, which can be changed.
class LoadedScene {
public:
    const Scene& operator*() const { return scene_; }
    const Scene* operator->() const { return &scene_; }
    operator Scene() && { return std::move(scene_); }

private:
    friend LoadedScene loadScene(const std::string& path, const LoadOptions& options);
    explicit LoadedScene(Scene&& scene) : scene_(std::move(scene)) {}

    Scene scene_;
};

/// Reads a scene with the reader for its file's extension (see sceneReaders) and validates it.
/// Throws SceneError with the place of the first mistake.
LoadedScene loadScene(const std::string& path, const LoadOptions& options = {});

} // namespace calotype
