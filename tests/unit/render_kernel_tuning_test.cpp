// What is chosen by the kind of device.
#include "render/kernel_tuning.h"

#include <gtest/gtest.h>

namespace calotype::test {
namespace {

TEST(KernelTuningTest, SharesTheStackOnGpusAlone) {
    DeviceInfo device;
    device.type = "CPU";
    EXPECT_FALSE(tuningFor(device).sharesStack);
    for (const char* type : {"discrete GPU", "integrated GPU", "virtual GPU"}) {
        device.type = type;
        EXPECT_TRUE(tuningFor(device).sharesStack) << type;
    }
}

} // namespace
} // namespace calotype::test
