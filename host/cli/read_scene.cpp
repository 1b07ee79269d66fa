#include "cli/read_scene.h"

#include <cstdio>

#include "read/load.h"

namespace calotype {

Scene readScene(const SceneOptions& options, const std::optional<PictureSize>& size,
                const std::function<void(const std::string& what, double done)>& onProgress) {
    LoadOptions load;
    load.overrides = options.overrides;
    load.missingTextures = options.missingTextures;
    load.size = size;
    load.onProgress = [&](const std::string& what, double done) {
        onProgress("loading " + what, done);
    };
    return loadScene(options.path, load);
}

void printWarnings(const Scene& scene) {
    for (const std::string& warning : scene.warnings)
        std::fprintf(stderr, "calotype: warning: %s\n", warning.c_str());
}

RenderSettings settingsOf(const Scene& scene) {
    RenderSettings settings;
    settings.width = scene.film.width;
    settings.height = scene.film.height;
    settings.crop = {0, 0, settings.width, settings.height};
    settings.samplesPerPixel = scene.render.samplesPerPixel;
    settings.maxBounces = scene.render.maxBounces;
    settings.seed = scene.render.seed;
    settings.sampler = Sampler::Sobol;
    return settings;
}

} // namespace calotype
