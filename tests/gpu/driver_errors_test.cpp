// What a driver's failures become: a sentence each, and for a lost device what to do.
#include <gtest/gtest.h>

#include "base/error.h"
#include "gpu/vulkan.h"

namespace calotype::test {
namespace {

template <typename Error>
std::string sentenceOf(const char* call) {
    try {
        callVulkan([&] { throw Error(call); });
    } catch (const GpuError& error) {
        return error.what();
    }
    return "no GpuError";
}

TEST(DriverErrorsTest, LostDeviceSaysWhatToDo) {
    const std::string sentence = sentenceOf<vk::DeviceLostError>("vkWaitForFences");
    for (const char* part : {"device was lost", "vkWaitForFences", "ErrorDeviceLost",
                             "smaller --size", "another --device"})
        EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
}

TEST(DriverErrorsTest, OthersNameCallAndResult) {
    const std::string memory = sentenceOf<vk::OutOfDeviceMemoryError>("vkAllocateMemory");
    EXPECT_NE(memory.find("out of memory (vkAllocateMemory"), std::string::npos) << memory;
    const std::string other = sentenceOf<vk::InitializationFailedError>("vkCreateDevice");
    EXPECT_NE(other.find("vkCreateDevice: ErrorInitializationFailed"), std::string::npos) << other;
}

} // namespace
} // namespace calotype::test
