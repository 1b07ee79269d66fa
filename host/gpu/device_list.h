#pragma once

#include <string_view>
#include <vector>

#include "gpu/device_info.h"
#include "gpu/instance.h"

namespace calotype {

std::vector<DeviceInfo> listDevices(const Instance& instance);

/// Picks a device: by `wish` (an index, or part of a name in any case) if it is not empty,
/// otherwise the highest rank, the first of equals. `askedBy` is put before the wish in messages,
/// such as "--device". Throws GpuError, naming the devices there are, where nothing fits.
DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy = "");

} // namespace calotype
