#include "gpu/choose_device.h"

#include <algorithm>
#include <iterator>
#include <string>

#include "base/error.h"
#include "base/lowercase.h"
#include "gpu/vulkan.h"

namespace calotype {
namespace {

std::string quoteNames(const std::vector<DeviceInfo>& devices) {
    std::string names;
    for (const DeviceInfo& device : devices)
        names +=
            (names.empty() ? "" : ", ") + std::to_string(device.index) + " '" + device.name + "'";
    return names;
}

bool isNumber(const std::string& wish) {
    return wish.find_first_not_of("0123456789") == std::string::npos;
}

bool isIndexOf(const DeviceInfo& device, const std::string& wish) {
    return std::to_string(device.index) == wish;
}

/// nvidia-smi prints "GPU-" before a UUID.
bool isUuidOf(const DeviceInfo& device, const std::string& wish) {
    constexpr size_t kFewestDigits = 8;
    const std::string digits = wish.starts_with("gpu-") ? wish.substr(4) : wish;
    return digits.size() >= kFewestDigits && device.uuid.starts_with(digits);
}

/// Some tools print a domain of eight digits, others none.
bool isAddressOf(const DeviceInfo& device, const std::string& wish) {
    return std::ranges::count(wish, ':') > 0 && !device.pciAddress.empty() &&
           (wish.ends_with(device.pciAddress) || device.pciAddress.ends_with(":" + wish));
}

/// A number alone is an index, not a part of "LLVM 15".
bool isPartOf(const std::string& text, const std::string& wish) {
    return !isNumber(wish) && lowercase(text).find(wish) != std::string::npos;
}

/// The ways in which a wish can fit a device, the most exact first. Wishes are in lower case.
using Fits = bool (*)(const DeviceInfo&, const std::string&);
constexpr Fits kWaysToFit[] = {
    isIndexOf,
    isUuidOf,
    isAddressOf,
    [](const DeviceInfo& device, const std::string& wish) { return isPartOf(device.name, wish); },
    [](const DeviceInfo& device, const std::string& wish) { return isPartOf(device.driver, wish); },
};

/// llvmpipe is many times faster than other drivers that render on the CPU.
bool isBetter(const DeviceInfo& a, const DeviceInfo& b) {
    if (a.rank != b.rank)
        return a.rank > b.rank;
    if (a.driverId == b.driverId)
        return a.driverVersion > b.driverVersion;
    return a.driverId == VK_DRIVER_ID_MESA_LLVMPIPE;
}

/// The best of those that can run Calotype; null if none can.
const DeviceInfo* bestOf(const std::vector<DeviceInfo>& devices) {
    const DeviceInfo* best = nullptr;
    for (const DeviceInfo& device : devices)
        if (device.missing.empty() && (!best || isBetter(device, *best)))
            best = &device;
    return best;
}

DeviceChoice chooseByWish(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy) {
    const std::string asked =
        std::string(askedBy) + (askedBy.empty() ? "'" : " '") + std::string(wish) + "'";
    const std::string lowered = lowercase(wish);
    for (const Fits fits : kWaysToFit) {
        std::vector<DeviceInfo> fitting;
        std::ranges::copy_if(devices, std::back_inserter(fitting),
                             [&](const DeviceInfo& device) { return fits(device, lowered); });
        if (const DeviceInfo* best = bestOf(fitting))
            return {best->index, "matches " + asked};
        if (!fitting.empty())
            throw GpuError("the device '" + fitting.front().name + "' that " + asked +
                           " names lacks " + fitting.front().missing);
    }
    throw GpuError("no device matches " + asked + "; there are: " + quoteNames(devices));
}

} // namespace

DeviceChoice chooseDevice(const std::vector<DeviceInfo>& devices, std::string_view wish,
                          std::string_view askedBy) {
    if (devices.empty())
        throw GpuError("there is no Vulkan device; install a driver (Debian: mesa-vulkan-drivers, "
                       "which renders on the CPU)");
    if (!wish.empty())
        return chooseByWish(devices, wish, askedBy);
    const DeviceInfo* best = bestOf(devices);
    if (!best)
        throw GpuError("no device can run Calotype: '" + devices.front().name + "' lacks " +
                       devices.front().missing);
    return {best->index, devices.size() == 1 ? "the only device"
                                             : "the best " + best->type + ", the best kind here"};
}

} // namespace calotype
