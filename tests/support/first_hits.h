#pragma once

#include <functional>
#include <optional>

#include "engine/compile_scene.h"
#include "render/first_hit_pass.h"
#include "scene/scene.h"
#include "support/gpu_test.h"

namespace calotype::test {

struct FirstHits {
    FirstHitImage image;
    uint64_t cutPixels = 0;
    GpuScene packed;
};

/// How a test wants first hits; what is absent is taken from the scene.
struct FirstHitWish {
    std::optional<Crop> crop;
    std::optional<SceneFeatures> features; ///< else those that the scene needs
    std::function<void(double)> onProgress;
};

/// The first hits of a scene on the test device, through every stage that the program goes through.
inline FirstHits firstHitsOf(const Scene& scene, const FirstHitWish& wish = {}) {
    RenderSettings settings;
    settings.width = scene.film.width;
    settings.height = scene.film.height;
    settings.crop = wish.crop.value_or(Crop{0, 0, settings.width, settings.height});
    settings.bvh = BvhBuilder::Sah;
    FirstHits result;
    result.packed = compileScene(scene, settings, {.allUvs = true, .onProgress = {}}).packed;
    const SceneBuffers buffers(testDevice(), result.packed);
    FirstHitPass pass(testDevice(), result.packed, buffers,
                      wish.features.value_or(result.packed.features), settings);
    result.image = pass.run(wish.onProgress);
    result.cutPixels = pass.cutPixels();
    return result;
}

} // namespace calotype::test
