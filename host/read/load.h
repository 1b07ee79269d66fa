#pragma once

#include <cstdint>
#include <functional>
#include <limits>
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

/// What to do if the image file of a texture is missing, or cannot be read.
enum class MissingTextures : uint8_t { Fail, Warn }; ///< Warn: show magenta instead

/// What a device has for the images of a scene.
struct DeviceTextureMemory {
    uint64_t bytes = std::numeric_limits<uint64_t>::max();
    std::string device = {};   ///< its name
    bool isHostMemory = false; ///< it is part of the host's memory
};

struct LoadOptions {
    MissingTextures missingTextures = MissingTextures::Fail;
    std::vector<SceneOverride> overrides;
    std::optional<PictureSize> size; ///< replaces that of the scene's film
    ViewOptions view;
    /// What the device has; called if the images are large, before they are decoded. Empty: no
    /// device is used.
    std::function<DeviceTextureMemory()> deviceTextureMemory;
    std::optional<uint64_t> hostMemory; ///< bytes for images; none: what is available
    /// Called from time to time with a file name such as "chair.obj", and the share done in [0, 1].
    std::function<void(const std::string& what, double done)> onProgress;
};

/// A scene that loadScene has read and checked. Converts to a Scene, which can be changed.
class LoadedScene {
public:
    const Scene& operator*() const { return scene_; }
    const Scene* operator->() const { return &scene_; }
    operator Scene() && { return std::move(scene_); }

    /// The paths of all files that were read: that of the scene first, then those that it names.
    const std::vector<std::string>& files() const { return files_; }

private:
    friend LoadedScene loadScene(const std::string& path, const LoadOptions& options);
    LoadedScene(Scene&& scene, std::vector<std::string>&& files)
        : scene_(std::move(scene)), files_(std::move(files)) {}

    Scene scene_;
    std::vector<std::string> files_;
};

/// Reads a scene with the reader for its file's extension (see sceneReaders) and validates it.
/// Throws SceneError at the first mistake, and GpuError or Error if images exceed the memory.
LoadedScene loadScene(const std::string& path, const LoadOptions& options = {});

} // namespace calotype
