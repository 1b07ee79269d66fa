#include "engine/reference_engine.h"

#include <algorithm>
#include <thread>

#include "engine/stage_seconds.h"
#include "render/feature_rays.h"
#include "render/reference_features.h"
#include "render/reference_first_hits.h"

namespace calotype {
namespace {

uint32_t threadsFor(const DeviceOptions& options) {
    return options.threads > 0 ? options.threads
                               : std::max(1u, std::thread::hardware_concurrency());
}

} // namespace

ReferenceEngine::ReferenceEngine(const DeviceOptions& options, const Scene& scene,
                                 const EngineRequest& request, StageSeconds& seconds)
    : settings_(request.settings), threads_(threadsFor(options)),
      tracer_(timed(seconds.build,
                    [&] {
                        return reference::ReferenceTracer(
                            scene, {settings_.width, settings_.height}, settings_.maxBounces,
                            settings_.transport, settings_.textureFilter);
                    })),
      block_(tracer_, settings_, threads_) {}

FirstHitImage ReferenceEngine::firstHits(const std::function<void(double)>& onProgress) {
    return referenceFirstHits(tracer_, settings_, threads_, onProgress);
}

FeatureImage ReferenceEngine::features(const std::function<void(double)>& onProgress,
                                       const OnPrimitives& onPrimitives) {
    return referenceFeatures(tracer_, settings_, kFeatureRays, threads_, onProgress, onPrimitives);
}

DeviceInfo ReferenceEngine::info() const {
    DeviceInfo info;
    info.name = "reference";
    info.type = "CPU";
    info.driver = "double precision";
    return info;
}

} // namespace calotype
