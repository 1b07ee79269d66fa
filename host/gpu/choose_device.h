#pragma once

#include <string_view>
#include <vector>

#include "gpu/device_info.h"

namespace calotype {

/// Chooses among the devices. A `wish` is an index, a PCI address, a UUID or its first eight or
/// more digits, or a part of a device's name or of its driver's name and version, ignoring case; an
/// index, an address or a UUID goes before a name, a name before a driver. Without a wish a device
/// of the highest rank is taken: on the CPU llvmpipe before others, of one driver the newest
/// version, else the first. Messages name `askedBy` as the source of the wish, such as "--device".
/// Throws GpuError with the list of devices if none fits.
DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy = "");

} // namespace calotype
