#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/device_session.h"
#include "engine/stage_seconds.h"
#include "gpu/device_info.h"
#include "image/features.h"
#include "image/first_hit.h"
#include "render/block_tracer.h"
#include "scene/scene.h"
#include "settings/render_settings.h"

namespace calotype {

/// Renders the samples of a picture: a Vulkan device, or the reference tracer on the CPU.
class RenderEngine {
public:
    virtual ~RenderEngine() = default;

    virtual BlockTracer& tracer() = 0;

    /// Largest emitted radiance of any channel, W/(m^2 sr).
    virtual double maxRadiance() const = 0;

    /// Needs EngineRequest::wantsFirstHits. `onProgress` is called with the share done in [0, 1].
    virtual FirstHitImage firstHits(const std::function<void(double)>& onProgress) = 0;

    /// Needs EngineRequest::wantsFeatures. `onProgress` is called with the share done in [0, 1].
    virtual FeatureImage features(const std::function<void(double)>& onProgress,
                                  const OnPrimitives& onPrimitives) = 0;

    /// Pixels of the first hits that show a surface the ray should have passed through.
    virtual uint64_t cutPixels() const { return 0; }

    /// Rays of the features that a limit ended at a surface where they would go on.
    virtual uint64_t cutFeatureRays() const { return 0; }

    virtual DeviceInfo info() const = 0;

    /// How the BVH was built: "median", "sah", or "reference".
    virtual const char* tree() const = 0;
    virtual uint64_t deviceBytes() const { return 0; }

    /// Throws GpuError for errors that were only found during the render.
    virtual void finish() const {}
};

struct EngineRequest {
    RenderSettings settings;
    bool wantsFirstHits = false;
    bool wantsFeatures = false;
    /// Called with the current step and its share done in [0, 1]; may throw to end it.
    std::function<void(const std::string&, double)> onProgress = {};
};

/// The engine that the options of `device` name, ready to render. `scene` must outlive it. Stores
/// the times of building, uploading and compiling in `seconds`. Throws GpuError and SceneError.
std::unique_ptr<RenderEngine> makeEngine(DeviceKeeper& device, const Scene& scene,
                                         const EngineRequest& request, StageSeconds& seconds);

} // namespace calotype
