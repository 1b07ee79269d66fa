#pragma once

#include <optional>
#include <vector>

#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// All of the picture, with the scene's own size, samples, bounces and seed, and the defaults for
/// the rest.
RenderSettings defaultSettings(const Scene& scene);

/// Throws SettingError where the device cannot do what a setting says, whatever the scene.
void requireKnownTo(const DeviceOptions& device, const RenderSettings& settings);

/// Throws SettingError where a setting is out of its range, or does not go with the others or the
/// device.
void requireRenderable(const RenderSettings& settings, const DeviceOptions& device);

/// Gives all textures of a scene one filter, if there is one; takes it back in the end.
class TextureFilterOverride {
public:
    /// The scene must outlive this.
    TextureFilterOverride(Scene& scene, const std::optional<TextureFilter>& filter);
    ~TextureFilterOverride();
    TextureFilterOverride(const TextureFilterOverride&) = delete;
    TextureFilterOverride& operator=(const TextureFilterOverride&) = delete;

private:
    std::vector<Texture>& textures_;
    std::vector<Texture> before_; ///< empty where nothing was changed
};

} // namespace calotype
