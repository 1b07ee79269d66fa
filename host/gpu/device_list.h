#pragma once

#include <vector>

#include "gpu/device_info.h"
#include "gpu/instance.h"

namespace calotype {

/// All devices, in the order of the driver loader. Throws GpuError if the driver fails.
std::vector<DeviceInfo> listDevices(const Instance& instance);

} // namespace calotype
