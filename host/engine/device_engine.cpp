#include "engine/device_engine.h"

#include <utility>

#include "engine/stage_seconds.h"
#include "render/feature_pass.h"
#include "render/first_hit_pass.h"
#include "render/statistical_pass.h"

namespace calotype {
namespace {

/// Sets `builder` to the builder that was used.
GpuScene compile(const Scene& scene, const EngineRequest& request, BvhBuilder& builder) {
    CompileOptions options;
    options.allUvs = request.wantsFirstHits;
    if (request.onProgress)
        options.onProgress = [&](double done) { request.onProgress("building the BVH", done); };
    CompiledScene compiled = compileScene(scene, request.settings, options);
    builder = compiled.builder;
    return std::move(compiled.packed);
}

/// Bytes that denoising needs on the device.
uint64_t denoiserBytes(const RenderSettings& settings) {
    return settings.denoiser == DenoiserKind::Statistical
               ? statisticalPassBytes(settings.crop.width, settings.crop.height)
               : 0;
}

/// Throws GpuError if the device does not have enough memory.
uint64_t requiredBytes(const Device& device, const GpuScene& packed, const EngineRequest& request) {
    const uint64_t bytes = packed.bytes() + pathTracerBytes(device, request.settings) +
                           (request.wantsFirstHits ? firstHitPassBytes(request.settings) : 0) +
                           (request.wantsFeatures ? featurePassBytes(request.settings) : 0) +
                           denoiserBytes(request.settings);
    requireMemory(device, bytes);
    return bytes;
}

} // namespace

DeviceEngine::DeviceEngine(std::shared_ptr<const DeviceSession> session, const Scene& scene,
                           const EngineRequest& request, StageSeconds& seconds)
    : settings_(request.settings), session_(std::move(session)),
      packed_(timed(seconds.build, [&] { return compile(scene, request, builder_); })),
      deviceBytes_(requiredBytes(device(), packed_, request)),
      buffers_(timed(seconds.upload, [&] { return SceneBuffers(device(), packed_); })),
      tracer_(timed(seconds.compile, [&] {
          return PathTracer(device(), packed_, buffers_, packed_.features, settings_);
      })) {}

FirstHitImage DeviceEngine::firstHits(const std::function<void(double)>& onProgress) {
    FirstHitPass pass(device(), packed_, buffers_, packed_.features, settings_);
    FirstHitImage hits = pass.run(onProgress);
    cutPixels_ = pass.cutPixels();
    return hits;
}

FeatureImage DeviceEngine::features(const std::function<void(double)>& onProgress,
                                    const OnPrimitives& onPrimitives) {
    FeaturePass pass(device(), packed_, buffers_, packed_.features, settings_);
    FeatureImage features = pass.run(kFeatureRays, onProgress, onPrimitives);
    cutFeatureRays_ = pass.cutRays();
    return features;
}

} // namespace calotype
