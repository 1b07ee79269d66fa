#include "support/device_tracer.h"

#include "engine/compile_scene.h"
#include "engine/scene_settings.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

/// With the tree of the surface area heuristic, however few samples the settings have.
GpuScene pack(const Scene& scene, RenderSettings settings) {
    settings.bvh = BvhBuilder::Sah;
    return compileScene(scene, settings).packed;
}

} // namespace

RenderSettings squareSettings(const Scene& scene, uint32_t side, uint32_t seed) {
    RenderSettings settings;
    settings.width = side;
    settings.height = side;
    settings.crop = {0, 0, side, side};
    settings.maxBounces = scene.render.maxBounces;
    settings.seed = seed;
    settings.sampler = Sampler::Independent;
    settings.transport.lightChoice = defaultLightChoice(scene);
    return settings;
}

DeviceTracer::DeviceTracer(const Scene& scene, const RenderSettings& settings,
                           const std::optional<SceneFeatures>& features,
                           const std::optional<KernelTuning>& tuning)
    : packed_(pack(scene, settings)), buffers_(testDevice(), packed_),
      tracer_(testDevice(), packed_, buffers_, features.value_or(packed_.features), settings,
              tuning) {}

} // namespace calotype::test
