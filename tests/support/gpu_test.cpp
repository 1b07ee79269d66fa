#include "support/gpu_test.h"

#include <cstdlib>
#include <optional>
#include <string_view>

namespace calotype::test {
namespace {

std::optional<Instance> instance;
std::optional<Device> device;

/// Destroys the device before the process exits. The validation layers of Debian 13 have destroyed
/// their own global objects by the time that those of this file are destroyed, and crash.
class DeviceEnvironment : public testing::Environment {
    void TearDown() override {
        device.reset();
        instance.reset();
    }
};

[[maybe_unused]] const testing::Environment* const registered =
    testing::AddGlobalTestEnvironment(new DeviceEnvironment);

} // namespace

const Device& testDevice() {
    if (!device) {
        const char* validation = std::getenv("CALOTYPE_VALIDATION");
        instance.emplace(!validation || std::string_view(validation) != "0");
        const char* wish = std::getenv("CALOTYPE_DEVICE");
        device.emplace(*instance, wish ? wish : "", "CALOTYPE_DEVICE");
    }
    return *device;
}

void GpuTest::TearDown() {
    if (!instance)
        return;
    for (const std::string& message : instance->validationMessages())
        ADD_FAILURE() << "validation layer: " << message;
}

} // namespace calotype::test
