#include "cli/render_engine.h"

#include "cli/device_engine.h"
#include "cli/reference_engine.h"

namespace calotype {

std::unique_ptr<RenderEngine> makeEngine(const DeviceOptions& options, const Scene& scene,
                                         const EngineRequest& request, StageSeconds& seconds) {
    if (isReference(options))
        return std::make_unique<ReferenceEngine>(options, scene, request, seconds);
    return std::make_unique<DeviceEngine>(options, scene, request, seconds);
}

} // namespace calotype
