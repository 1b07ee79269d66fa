#include "engine/devices.h"

#include "base/lowercase.h"
#include "gpu/choose_device.h"
#include "gpu/device_list.h"
#include "gpu/instance.h"

namespace calotype {

bool isReference(const DeviceOptions& options) { return lowercase(options.device) == "reference"; }

std::vector<DeviceInfo> allDevices(const DeviceOptions& options) {
    return listDevices(Instance(options.validates));
}

DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, const DeviceOptions& options) {
    return chooseDevice(devices, options.device, options.askedBy);
}

} // namespace calotype
