#pragma once

#include <vector>

#include "gpu/device_info.h"
#include "settings/device_options.h"

namespace calotype {

/// Whether the options name the reference tracer, which runs on no device.
bool isReference(const DeviceOptions& options);

/// All devices of this machine, in the order of the driver loader. Throws GpuError if Vulkan is
/// missing.
std::vector<DeviceInfo> allDevices(const DeviceOptions& options);

/// The device that the options name, or else the best. Throws GpuError if there is none.
DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, const DeviceOptions& options);

} // namespace calotype
