#include "support/device_tracer.h"

#include "accel/build_bvh.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

GpuScene pack(const Scene& scene, const RenderSettings& settings) {
    const glm::dvec3 origin = packingOrigin(scene);
    const auto primitives = collectPrimitives(scene, origin);
    return packScene(scene, primitives, buildBvh(primitives), origin,
                     static_cast<double>(settings.width) / settings.height);
}

} // namespace

RenderSettings squareSettings(const Scene& scene, uint32_t side, uint32_t seed) {
    RenderSettings settings;
    settings.width = side;
    settings.height = side;
    settings.crop = {0, 0, side, side};
    settings.maxBounces = scene.render.maxBounces;
    settings.seed = seed;
    return settings;
}

DeviceTracer::DeviceTracer(const Scene& scene, const RenderSettings& settings,
                           const std::optional<SceneFeatures>& features,
                           const std::optional<KernelTuning>& tuning)
    : packed_(pack(scene, settings)), buffers_(testDevice(), packed_),
      tracer_(testDevice(), packed_, buffers_, features.value_or(packed_.features), settings,
              tuning) {}

} // namespace calotype::test
