#pragma once

#include <string_view>
#include <vector>

#include "gpu/device_info.h"
#include "gpu/instance.h"

namespace calotype {

std::vector<DeviceInfo> listDevices(const Instance& instance);

/// Chooses a device: by `wish` (an index, or part of a name, ignoring case) if it is not empty,
/// otherwise the first with the highest rank. Messages name `askedBy` as the source of the wish,
/// such as "--device". Throws GpuError with the list of devices if none fits.
DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy = "");

} // namespace calotype
