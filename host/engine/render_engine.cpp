#include "engine/render_engine.h"

#include "engine/device_engine.h"
#include "engine/devices.h"
#include "engine/reference_engine.h"

namespace calotype {

std::unique_ptr<RenderEngine> makeEngine(DeviceKeeper& device, const Scene& scene,
                                         const EngineRequest& request, StageSeconds& seconds) {
    if (isReference(device.options()))
        return std::make_unique<ReferenceEngine>(device.options(), scene, request, seconds);
    return std::make_unique<DeviceEngine>(device.session(), scene, request, seconds);
}

} // namespace calotype
