#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/stage_seconds.h"
#include "gpu/device_info.h"
#include "image/first_hit.h"
#include "render/block_tracer.h"
#include "scene/scene.h"
#include "settings/device_options.h"
#include "settings/render_settings.h"

namespace calotype {

/// What makes a picture's samples: a Vulkan device, or the reference tracer on the CPU.
class RenderEngine {
public:
    virtual ~RenderEngine() = default;

    virtual BlockTracer& tracer() = 0;

    /// Largest emitted radiance of any channel, W/(m^2 sr).
    virtual double maxRadiance() const = 0;

    /// Only of an engine that was made for it. `onProgress` is told the share of the work done.
    virtual FirstHitImage firstHits(const std::function<void(double)>& onProgress) = 0;

    /// Pixels of the first hits that show what they should see through.
    virtual uint64_t cutPixels() const { return 0; }

    virtual DeviceInfo info() const = 0;

    /// How its tree was built: "median", "sah", or "reference".
    virtual const char* tree() const = 0;
    virtual uint64_t deviceBytes() const { return 0; }

    /// Throws GpuError for what only came to light on the way.
    virtual void finish() const {}
};

struct EngineRequest {
    RenderSettings settings;
    bool wantsFirstHits = false;
    /// Told what is being done, and the share of it done in [0, 1]; may throw to end it.
    std::function<void(const std::string&, double)> onProgress = {};
};

/// The engine that the options name, ready to render. `scene` must outlive it; `seconds` takes the
/// times of building, uploading and compiling. Throws GpuError and SceneError.
std::unique_ptr<RenderEngine> makeEngine(const DeviceOptions& options, const Scene& scene,
                                         const EngineRequest& request, StageSeconds& seconds);

} // namespace calotype
