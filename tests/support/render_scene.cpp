#include "support/render_scene.h"

#include "accel/median_split.h"
#include "pack/gpu_scene.h"
#include "render/scene_buffers.h"
#include "scene/load.h"
#include "support/gpu_test.h"

namespace calotype::test {

RenderedScene renderScene(const Scene& scene, const RenderWish& wish) {
    RenderSettings settings;
    settings.width = wish.width.value_or(scene.film.width);
    settings.height = wish.height.value_or(scene.film.height);
    settings.crop = wish.crop.value_or(Crop{0, 0, settings.width, settings.height});
    settings.samplesPerPixel = wish.samplesPerPixel.value_or(scene.render.samplesPerPixel);
    settings.maxBounces = wish.maxBounces.value_or(scene.render.maxBounces);
    settings.seed = wish.seed.value_or(scene.render.seed);

    const glm::dvec3 origin = packingOrigin(scene);
    const auto primitives = collectPrimitives(scene, origin);
    const Bvh bvh = buildMedianSplit(primitives);
    const GpuScene packed = packScene(scene, primitives, bvh, origin,
                                      static_cast<double>(settings.width) / settings.height);
    const SceneBuffers buffers(testDevice(), packed);
    PathTracer tracer(testDevice(), packed, buffers, wish.features.value_or(packed.features),
                      settings);
    RenderSession session(tracer, settings, packed.maxRadiance);
    session.run(wish.observer, wish.passSamples);
    return {session.picture(), session.totals(), packed.features};
}

Scene projectScene(const std::string& path) {
    return loadScene(std::string(CALOTYPE_SOURCE_DIR) + "/" + path);
}

} // namespace calotype::test
