#pragma once

#include <string_view>
#include <vector>

#include "gpu/device_info.h"

namespace calotype {

/// Chooses among the devices. A `wish` is an index, a UUID or its first eight or more digits, a PCI
/// address, or a part of a device's name or of its driver's name and version, ignoring case; the
/// kinds that come first in this list are tried first. Among several devices that fit, and without
/// a wish, one of the highest rank is taken: on the CPU llvmpipe before others, of one driver the
/// newest version, else the first. Messages name `askedBy` as the source of the wish, such as
/// "--device". Throws GpuError with the list of devices if none fits.
DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy = "");

} // namespace calotype
