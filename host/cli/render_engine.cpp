#include "cli/render_engine.h"

#include "cli/device_engine.h"
#include "cli/reference_engine.h"

namespace calotype {

std::unique_ptr<RenderEngine> makeEngine(const DeviceOptions& options, const Scene& scene,
                                         const EngineWish& wish, StageSeconds& seconds) {
    if (isReference(options))
        return std::make_unique<ReferenceEngine>(options, scene, wish, seconds);
    return std::make_unique<DeviceEngine>(options, scene, wish, seconds);
}

} // namespace calotype
