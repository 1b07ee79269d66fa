#include "engine/render_engine.h"

#include "engine/device_engine.h"
#include "engine/devices.h"
#include "engine/reference_engine.h"

namespace calotype {

std::unique_ptr<RenderEngine> makeEngine(const DeviceOptions& options, const Scene& scene,
                                         const EngineRequest& request, StageSeconds& seconds) {
    if (isReference(options))
        return std::make_unique<ReferenceEngine>(options, scene, request, seconds);
    return std::make_unique<DeviceEngine>(options, scene, request, seconds);
}

} // namespace calotype
