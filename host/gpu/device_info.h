#pragma once

#include <cstdint>
#include <string>

namespace calotype {

/// A physical device, as shown to users.
struct DeviceInfo {
    uint32_t index = 0; ///< in the order of the driver loader
    std::string name;
    std::string type;      ///< "discrete GPU", "integrated GPU", "virtual GPU", "CPU" or "other"
    std::string driver;    ///< name and version
    uint32_t driverId = 0; ///< VkDriverId
    uint32_t driverVersion = 0; ///< greater is newer, among versions of one driver
    std::string uuid;           ///< 32 hexadecimal digits and dashes, as tools of drivers print it
    std::string pciAddress;     ///< "0000:3b:00.0"; empty if it is not known
    uint64_t memoryBytes = 0;   ///< of the largest heap on the device
    std::string apiVersion;     ///< Vulkan's, such as "1.3.230"
    uint32_t subgroupSize = 1;
    std::string missing; ///< the first missing requirement; empty if the device can run Calotype
    int rank = 0;        ///< by type: a higher rank is preferred
};

struct DeviceChoice {
    uint32_t index = 0;
    std::string reason; ///< such as "the only device" or "matches --device 'nvidia'"
};

} // namespace calotype
