#include "gpu/device_list.h"

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace calotype {
namespace {

struct TypeName {
    const char* name;
    int rank;
};

TypeName typeName(vk::PhysicalDeviceType type) {
    switch (type) {
    case vk::PhysicalDeviceType::eDiscreteGpu:
        return {"discrete GPU", 4};
    case vk::PhysicalDeviceType::eIntegratedGpu:
        return {"integrated GPU", 3};
    case vk::PhysicalDeviceType::eVirtualGpu:
        return {"virtual GPU", 2};
    case vk::PhysicalDeviceType::eCpu:
        return {"CPU", 1};
    default:
        return {"other", 0};
    }
}

std::string versionText(uint32_t version) {
    return std::to_string(VK_API_VERSION_MAJOR(version)) + "." +
           std::to_string(VK_API_VERSION_MINOR(version)) + "." +
           std::to_string(VK_API_VERSION_PATCH(version));
}

/// The first requirement that the device does not meet, or nothing.
std::string missingRequirement(const vk::raii::PhysicalDevice& device,
                               const vk::PhysicalDeviceSubgroupProperties& subgroup) {
    if (device.getProperties().apiVersion < VK_API_VERSION_1_2)
        return "Vulkan 1.2";
    const auto families = device.getQueueFamilyProperties();
    if (std::none_of(families.begin(), families.end(), [](const vk::QueueFamilyProperties& family) {
            return static_cast<bool>(family.queueFlags & vk::QueueFlagBits::eCompute);
        }))
        return "a compute queue";
    constexpr vk::SubgroupFeatureFlags kNeeded =
        vk::SubgroupFeatureFlagBits::eArithmetic | vk::SubgroupFeatureFlagBits::eBallot;
    if ((subgroup.supportedOperations & kNeeded) != kNeeded ||
        !(subgroup.supportedStages & vk::ShaderStageFlagBits::eCompute))
        return "subgroup arithmetic and ballots in compute shaders";
    const auto texels = device.getFormatProperties(vk::Format::eR32G32B32A32Uint).bufferFeatures;
    if (!(texels & vk::FormatFeatureFlagBits::eUniformTexelBuffer))
        return "texel buffers of 128-bit rows";
    const auto image =
        device.getFormatProperties(vk::Format::eR32G32B32A32Sfloat).optimalTilingFeatures;
    if (!(image & vk::FormatFeatureFlagBits::eStorageImage))
        return "32-bit float storage images";
    return {};
}

/// Bytes in hexadecimal, with dashes in the usual places.
std::string uuidText(const vk::ArrayWrapper1D<uint8_t, VK_UUID_SIZE>& bytes) {
    std::string text;
    for (size_t i = 0; i < VK_UUID_SIZE; ++i) {
        char digits[3];
        std::snprintf(digits, sizeof digits, "%02x", bytes[i]);
        text += (i == 4 || i == 6 || i == 8 || i == 10 ? "-" : "") + std::string(digits);
    }
    return text;
}

/// Empty if the driver does not tell.
std::string pciAddress(const vk::raii::PhysicalDevice& device) {
    const auto extensions = device.enumerateDeviceExtensionProperties();
    if (std::ranges::none_of(extensions, [](const vk::ExtensionProperties& extension) {
            return std::string_view(extension.extensionName) == VK_EXT_PCI_BUS_INFO_EXTENSION_NAME;
        }))
        return {};
    const auto bus = device
                         .getProperties2<vk::PhysicalDeviceProperties2,
                                         vk::PhysicalDevicePCIBusInfoPropertiesEXT>()
                         .get<vk::PhysicalDevicePCIBusInfoPropertiesEXT>();
    char text[40];
    std::snprintf(text, sizeof text, "%04x:%02x:%02x.%x", bus.pciDomain, bus.pciBus, bus.pciDevice,
                  bus.pciFunction);
    return text;
}

uint64_t deviceMemory(const vk::raii::PhysicalDevice& device) {
    const vk::PhysicalDeviceMemoryProperties memory = device.getMemoryProperties();
    uint64_t largest = 0;
    for (uint32_t i = 0; i < memory.memoryHeapCount; ++i)
        if (memory.memoryHeaps[i].flags & vk::MemoryHeapFlagBits::eDeviceLocal)
            largest = std::max<uint64_t>(largest, memory.memoryHeaps[i].size);
    return largest;
}

} // namespace

std::vector<DeviceInfo> listDevices(const Instance& instance) {
    return callVulkan([&] {
        std::vector<DeviceInfo> devices;
        for (const vk::raii::PhysicalDevice& device :
             instance.handle().enumeratePhysicalDevices()) {
            const auto chain = device.getProperties2<
                vk::PhysicalDeviceProperties2, vk::PhysicalDeviceDriverProperties,
                vk::PhysicalDeviceIDProperties, vk::PhysicalDeviceSubgroupProperties>();
            const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
            const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
            const auto [type, rank] = typeName(properties.deviceType);
            DeviceInfo info;
            info.index = static_cast<uint32_t>(devices.size());
            info.name = properties.deviceName.data();
            info.type = type;
            info.driver = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
            info.driverId = static_cast<uint32_t>(driver.driverID);
            info.driverVersion = properties.driverVersion;
            info.uuid = uuidText(chain.get<vk::PhysicalDeviceIDProperties>().deviceUUID);
            info.pciAddress = pciAddress(device);
            info.memoryBytes = deviceMemory(device);
            info.apiVersion = versionText(properties.apiVersion);
            const auto& subgroup = chain.get<vk::PhysicalDeviceSubgroupProperties>();
            info.subgroupSize = subgroup.subgroupSize;
            info.missing = missingRequirement(device, subgroup);
            info.rank = rank;
            devices.push_back(std::move(info));
        }
        return devices;
    });
}

} // namespace calotype
