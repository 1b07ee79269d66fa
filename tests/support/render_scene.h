#pragma once

#include <optional>

#include "image/image.h"
#include "pack/scene_features.h"
#include "render/kernel_tuning.h"
#include "render/render_session.h"
#include "scene/scene.h"

namespace calotype::test {

struct RenderedScene {
    Image image;
    RenderTotals totals;
    SceneFeatures needed; ///< by the scene, whatever the wish
    Film film;
};

/// How a test wants a scene rendered; what is absent is taken from the scene.
struct RenderWish {
    std::optional<uint32_t> width;
    std::optional<uint32_t> height;
    std::optional<uint32_t> samplesPerPixel;
    std::optional<uint32_t> maxBounces;
    std::optional<uint32_t> seed;
    Sampler sampler = Sampler::Independent;
    TransportSettings transport;
    std::optional<LightChoice> lightChoice; ///< whatever `transport` says
    std::optional<Crop> crop;
    std::optional<SceneFeatures> features; ///< else those that the scene needs
    std::optional<KernelTuning> tuning;    ///< else the device's
    uint32_t passSamples = 0;
    RenderObserver observer;
    RenderGoal goal;
};

/// Renders on the test device, through every stage that the program goes through.
RenderedScene renderScene(const Scene& scene, const RenderWish& wish = {});

/// A scene of the project, by its path from the project's root.
Scene projectScene(const std::string& path);

} // namespace calotype::test
