#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "gpu/instance.h"

namespace calotype {

/// A physical device as a person would want to know it.
struct DeviceInfo {
    uint32_t index = 0; ///< in the order of the driver loader
    std::string name;
    std::string type;       ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;     ///< name and version
    std::string apiVersion; ///< Vulkan's, such as "1.3.230"
    uint32_t subgroupSize = 1;
    std::string missing; ///< what it lacks to run Calotype; empty where it can
    int rank = 0;        ///< by type: the higher, the rather it is taken
};

struct DeviceChoice {
    uint32_t index = 0;
    std::string reason; ///< such as "the only device" or "matches --device 'nvidia'"
};

std::vector<DeviceInfo> listDevices(const Instance& instance);

/// Picks a device: by `wish` (an index, or part of a name in any case) if it is not empty,
/// otherwise the CALOTYPE_DEVICE variable's wish (unless that is "reference"), otherwise the
/// highest rank, the first of equals. Throws GpuError, naming the devices there are, where nothing
/// fits.
DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish);

} // namespace calotype
