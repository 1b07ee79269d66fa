#include "cli/device_engine.h"

#include "accel/build_bvh.h"
#include "cli/timed.h"
#include "render/first_hit_pass.h"

namespace calotype {
namespace {

/// Sets `builder` to the one it took.
GpuScene build(const Scene& scene, const EngineRequest& request, BvhBuilder& builder) {
    const glm::dvec3 origin = packingOrigin(scene);
    const std::vector<Primitive> primitives = collectPrimitives(scene, origin);
    BuildOptions options;
    options.onProgress = [&](double done) { request.onProgress("building the BVH", done); };
    const Crop& crop = request.settings.crop;
    const uint64_t paths = uint64_t{crop.width} * crop.height * request.settings.samplesPerPixel;
    builder = request.bvh.value_or(quickestBuilder(primitives.size(), paths));
    const Bvh bvh = buildBvh(primitives, builder, options);
    const bool all = request.compilesEverything;
    GpuScene packed =
        packScene(scene, primitives, bvh, origin,
                  static_cast<double>(request.settings.width) / request.settings.height,
                  {.allUvs = all || request.wantsFirstHits, .allNormals = all});
    if (all)
        packed.features = SceneFeatures::all();
    return packed;
}

/// Throws GpuError where the device has not enough.
uint64_t requiredBytes(const Device& device, const GpuScene& packed, const EngineRequest& request) {
    const uint64_t bytes = packed.bytes() + pathTracerBytes(device, request.settings) +
                           (request.wantsFirstHits ? firstHitPassBytes(request.settings) : 0);
    requireMemory(device, bytes);
    return bytes;
}

} // namespace

DeviceEngine::DeviceEngine(const DeviceOptions& options, const Scene& scene,
                           const EngineRequest& request, StageSeconds& seconds)
    : settings_(request.settings), session_(options),
      packed_(timed(seconds.build, [&] { return build(scene, request, builder_); })),
      deviceBytes_(requiredBytes(session_.device(), packed_, request)),
      buffers_(timed(seconds.upload, [&] { return SceneBuffers(session_.device(), packed_); })),
      tracer_(timed(seconds.compile, [&] {
          return PathTracer(session_.device(), packed_, buffers_, packed_.features, settings_);
      })) {}

FirstHitImage DeviceEngine::firstHits(const std::function<void(double)>& onProgress) {
    FirstHitPass pass(session_.device(), packed_, buffers_, packed_.features, settings_);
    FirstHitImage hits = pass.run(onProgress);
    cutPixels_ = pass.cutPixels();
    return hits;
}

} // namespace calotype
