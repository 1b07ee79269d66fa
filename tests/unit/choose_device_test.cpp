// Which device is taken, on machines with several.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "gpu/choose_device.h"
#include "gpu/vulkan.h"

namespace calotype::test {
namespace {

constexpr int kCpuRank = 1;
constexpr int kDiscreteRank = 4;

DeviceInfo device(const std::string& name, int rank, uint32_t driverId, uint32_t driverVersion) {
    DeviceInfo info;
    info.name = name;
    info.rank = rank;
    info.type = rank == kCpuRank ? "CPU" : "discrete GPU";
    info.driverId = driverId;
    info.driverVersion = driverVersion;
    return info;
}

std::vector<DeviceInfo> numbered(std::vector<DeviceInfo> devices) {
    for (size_t i = 0; i < devices.size(); ++i)
        devices[i].index = static_cast<uint32_t>(i);
    return devices;
}

const DeviceInfo kSwiftShader =
    device("SwiftShader Device", kCpuRank, VK_DRIVER_ID_GOOGLE_SWIFTSHADER, 5);
const DeviceInfo kLlvmpipe = device("llvmpipe (LLVM 15)", kCpuRank, VK_DRIVER_ID_MESA_LLVMPIPE, 1);
const DeviceInfo kNewLlvmpipe =
    device("llvmpipe (LLVM 19)", kCpuRank, VK_DRIVER_ID_MESA_LLVMPIPE, 104857607);

std::vector<DeviceInfo> twoEqualGpus() {
    std::vector<DeviceInfo> devices;
    for (const char* address : {"0000:17:00.0", "0000:ca:00.0"}) {
        DeviceInfo gpu =
            device("NVIDIA H200", kDiscreteRank, VK_DRIVER_ID_NVIDIA_PROPRIETARY, 2307915776);
        gpu.driver = "NVIDIA 550.54.15";
        gpu.pciAddress = address;
        gpu.uuid =
            std::string(address[5] == '1' ? "1f" : "9c") + "3a2b40-5c6d-7e8f-9a0b-1c2d3e4f5a6b";
        devices.push_back(gpu);
    }
    DeviceInfo cpu = kLlvmpipe;
    cpu.driver = "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)";
    devices.push_back(cpu);
    return numbered(devices);
}

TEST(ChooseDeviceTest, PrefersLlvmpipeOnTheCpu) {
    EXPECT_EQ(chooseDevice(numbered({kSwiftShader, kLlvmpipe}), "").index, 1u);
    EXPECT_EQ(chooseDevice(numbered({kLlvmpipe, kSwiftShader}), "").index, 0u);
}

TEST(ChooseDeviceTest, PrefersTheNewestDriverOfEqualDevices) {
    EXPECT_EQ(chooseDevice(numbered({kLlvmpipe, kNewLlvmpipe}), "").index, 1u);
    EXPECT_EQ(chooseDevice(numbered({kNewLlvmpipe, kLlvmpipe}), "").index, 0u);
    EXPECT_EQ(chooseDevice(numbered({kSwiftShader, kLlvmpipe, kNewLlvmpipe}), "").index, 2u);
    EXPECT_EQ(chooseDevice(twoEqualGpus(), "").index, 0u);
}

TEST(ChooseDeviceTest, LeavesOutWhatCannotRun) {
    std::vector<DeviceInfo> devices = twoEqualGpus();
    devices[0].missing = devices[1].missing = "Vulkan 1.2";
    EXPECT_EQ(chooseDevice(devices, "").index, 2u);
    EXPECT_THROW(chooseDevice(devices, "nvidia"), GpuError);
}

TEST(ChooseDeviceTest, FindsWhatAWishNames) {
    const std::vector<DeviceInfo> devices = twoEqualGpus();
    const std::vector<std::pair<std::string, uint32_t>> wishes = {
        {"1", 1},
        {"h200", 0},
        {"LLVMPIPE", 2},
        {"mesa 22", 2},
        {"550.54", 0},
        {"0000:ca:00.0", 1},
        {"ca:00.0", 1},
        {"00000000:CA:00.0", 1},
        {"9c3a2b40-5c6d-7e8f-9a0b-1c2d3e4f5a6b", 1},
        {"GPU-9c3a2b40-5c6d-7e8f-9a0b-1c2d3e4f5a6b", 1},
        {"9c3a2b40", 1},
    };
    for (const auto& [wish, index] : wishes)
        EXPECT_EQ(chooseDevice(devices, wish).index, index) << wish;
}

TEST(ChooseDeviceTest, TakesTheBestThatFits) {
    EXPECT_EQ(chooseDevice(numbered({kLlvmpipe, kNewLlvmpipe}), "llvmpipe").index, 1u);
    std::vector<DeviceInfo> devices = twoEqualGpus();
    devices[0].missing = "Vulkan 1.2";
    EXPECT_EQ(chooseDevice(devices, "nvidia").index, 1u);
}

TEST(ChooseDeviceTest, RefusesWhatNothingFits) {
    const std::vector<DeviceInfo> devices = twoEqualGpus();
    for (const char* wish : {"7", "22", "550", "radeon", "9c3a", "00:00.0", ":", "0000:17:00.1"})
        EXPECT_THROW(chooseDevice(devices, wish), GpuError) << wish;
    EXPECT_THROW(chooseDevice({}, ""), GpuError);
}

} // namespace
} // namespace calotype::test
