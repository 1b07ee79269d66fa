#include "cli/commands.h"

#include <cstdio>

#include "cli/device_environment.h"
#include "cli/exit_code.h"
#include "engine/devices.h"
#include "engine/json_document.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

/// Null if the text is empty.
Json textOrNull(const std::string& text) { return text.empty() ? Json() : Json(text); }

Json toJson(const DeviceInfo& device) {
    return {{"index", device.index},
            {"name", device.name},
            {"type", device.type},
            {"driver", device.driver},
            {"vulkan", device.apiVersion},
            {"uuid", device.uuid},
            {"pci_address", textOrNull(device.pciAddress)},
            {"memory_bytes", device.memoryBytes},
            {"missing", textOrNull(device.missing)}};
}

void printJson(const std::vector<DeviceInfo>& devices, const DeviceChoice& choice) {
    Json json = newJsonDocument();
    json["devices"] = Json::array();
    for (const DeviceInfo& device : devices)
        json["devices"].push_back(toJson(device));
    json["chosen"] = choice.index;
    json["reason"] = choice.reason;
    std::fputs(jsonText(json).c_str(), stdout);
}

void print(const DeviceInfo& device) {
    std::printf("%u  %s\n   %s, %s, Vulkan %s, %.1f GiB\n   UUID %s%s%s\n", device.index,
                device.name.c_str(), device.type.c_str(), device.driver.c_str(),
                device.apiVersion.c_str(), static_cast<double>(device.memoryBytes) / (1 << 30),
                device.uuid.c_str(), device.pciAddress.empty() ? "" : ", PCI ",
                device.pciAddress.c_str());
    if (!device.missing.empty())
        std::printf("   cannot be used, it lacks %s\n", device.missing.c_str());
}

} // namespace

int devicesCommand(const DevicesOptions& given) {
    const DeviceOptions options = withEnvironment(given.device, false);
    const auto devices = allDevices(options);
    if (given.asJson) {
        printJson(devices, chooseDevice(devices, options));
        return kExitDone;
    }
    for (const DeviceInfo& device : devices)
        print(device);
    const DeviceChoice choice = chooseDevice(devices, options);
    std::printf("would take %u, %s: %s\n", choice.index, devices[choice.index].name.c_str(),
                choice.reason.c_str());
    return kExitDone;
}

} // namespace calotype
