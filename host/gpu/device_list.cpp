#include "gpu/device_list.h"

#include <algorithm>
#include <charconv>
#include <optional>

#include "base/lowercase.h"

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

std::string quoteNames(const std::vector<DeviceInfo>& devices) {
    std::string names;
    for (const DeviceInfo& device : devices)
        names +=
            (names.empty() ? "" : ", ") + std::to_string(device.index) + " '" + device.name + "'";
    return names;
}

bool fits(const DeviceInfo& device, std::string_view wish) {
    uint32_t index = 0;
    const auto [end, error] = std::from_chars(wish.data(), wish.data() + wish.size(), index);
    if (error == std::errc() && end == wish.data() + wish.size())
        return device.index == index;
    return lowercase(device.name).find(lowercase(wish)) != std::string::npos;
}

DeviceChoice chooseByWish(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy) {
    const std::string asked =
        std::string(askedBy) + (askedBy.empty() ? "'" : " '") + std::string(wish) + "'";
    const auto found = std::find_if(devices.begin(), devices.end(),
                                    [&](const DeviceInfo& device) { return fits(device, wish); });
    if (found == devices.end())
        throw GpuError("no device matches " + asked + "; there are: " + quoteNames(devices));
    if (!found->missing.empty())
        throw GpuError("the device '" + found->name + "' that " + asked + " names lacks " +
                       found->missing);
    return {found->index, "matches " + asked};
}

} // namespace

std::vector<DeviceInfo> listDevices(const Instance& instance) {
    return callVulkan([&] {
        std::vector<DeviceInfo> devices;
        for (const vk::raii::PhysicalDevice& device :
             instance.handle().enumeratePhysicalDevices()) {
            const auto chain = device.getProperties2<vk::PhysicalDeviceProperties2,
                                                     vk::PhysicalDeviceDriverProperties,
                                                     vk::PhysicalDeviceSubgroupProperties>();
            const auto& properties = chain.get<vk::PhysicalDeviceProperties2>().properties;
            const auto& driver = chain.get<vk::PhysicalDeviceDriverProperties>();
            const auto [type, rank] = typeName(properties.deviceType);
            DeviceInfo info;
            info.index = static_cast<uint32_t>(devices.size());
            info.name = properties.deviceName.data();
            info.type = type;
            info.driver = std::string(driver.driverName.data()) + " " + driver.driverInfo.data();
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

DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy) {
    if (devices.empty())
        throw GpuError("there is no Vulkan device; install a driver (Debian: mesa-vulkan-drivers, "
                       "which renders on the CPU)");
    if (!wish.empty())
        return chooseByWish(devices, wish, askedBy);
    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& device : devices)
        if (device.missing.empty() && (!best || device.rank > best->rank))
            best = &device;
    if (!best)
        throw GpuError("no device can run Calotype: '" + devices.front().name + "' lacks " +
                       devices.front().missing);
    return {best->index, devices.size() == 1 ? "the only device"
                                             : "the first " + best->type + ", the best kind here"};
}

} // namespace calotype
