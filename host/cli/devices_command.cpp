#include "cli/commands.h"

#include <cstdio>

#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "engine/devices.h"

namespace calotype {

int devicesCommand(const DeviceOptions& given) {
    const DeviceOptions options = withEnvironment(given, false);
    const auto devices = allDevices(options);
    for (const DeviceInfo& device : devices)
        std::printf("%u  %s\n   %s, %s, Vulkan %s%s%s\n", device.index, device.name.c_str(),
                    device.type.c_str(), device.driver.c_str(), device.apiVersion.c_str(),
                    device.missing.empty() ? "" : "; cannot be used, it lacks ",
                    device.missing.c_str());
    const DeviceChoice choice = chooseDevice(devices, options);
    std::printf("would take %u, %s: %s\n", choice.index, devices[choice.index].name.c_str(),
                choice.reason.c_str());
    return kExitDone;
}

} // namespace calotype
