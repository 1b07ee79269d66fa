#include "engine/compile_scene.h"

#include "accel/build_bvh.h"

namespace calotype {

CompiledScene compileScene(const Scene& scene, const RenderSettings& settings,
                           const CompileOptions& options) {
    const bool all = settings.compilesEverything;
    CompiledScene compiled;
    const glm::dvec3 origin = packingOrigin(scene);
    compiled.primitives = collectPrimitives(scene, origin);
    // Paths of the whole film: a crop has the same BVH, so the same hits where surfaces coincide.
    const uint64_t paths = uint64_t{settings.width} * settings.height * settings.samplesPerPixel;
    compiled.builder = settings.bvh.value_or(quickestBuilder(compiled.primitives.size(), paths));
    BuildOptions build;
    build.onProgress = options.onProgress;
    compiled.bvh = buildBvh(compiled.primitives, compiled.builder, build);
    compiled.packed = packScene(scene, compiled.primitives, compiled.bvh, origin,
                                static_cast<double>(settings.width) / settings.height,
                                {.allUvs = all || options.allUvs,
                                 .allNormals = all,
                                 .lightChoice = settings.transport.lightChoice,
                                 .textureFilter = settings.textureFilter});
    if (all)
        compiled.packed.features = SceneFeatures::all();
    return compiled;
}

} // namespace calotype
