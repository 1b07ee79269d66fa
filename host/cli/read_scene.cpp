#include "cli/read_scene.h"

#include <cstdio>

#include "engine/devices.h"
#include "engine/scene_summary.h"

namespace calotype {

LoadedScene readScene(const SceneOptions& options, const GivenSettings& settings,
                      const DeviceOptions& device,
                      const std::function<void(const std::string& what, double done)>& onProgress) {
    LoadOptions load;
    load.overrides = options.overrides;
    load.missingTextures = options.missingTextures;
    load.view = options.view;
    RenderSettings given;
    settings.applyTo(given);
    if (settings.has("size"))
        load.size = PictureSize{given.width, given.height};
    if (!isReference(device))
        load.deviceTextureMemory = [&] { return textureMemoryOf(device); };
    load.onProgress = [&](const std::string& what, double done) {
        onProgress("loading " + what, done);
    };
    return loadScene(options.path, load);
}

void printWarning(const std::string& warning) {
    std::fprintf(stderr, "calotype: warning: %s\n", warning.c_str());
}

void printWarnings(const Scene& scene) {
    for (const std::string& warning : scene.warnings)
        printWarning(warning);
}

} // namespace calotype
