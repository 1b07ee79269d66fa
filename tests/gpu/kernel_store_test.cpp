// Kernels that a device has compiled are used again.
#include "gpu/kernel.h"

#include "kernels/sin_cos_two_pi.spv.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

class KernelStoreTest : public GpuTest {
protected:
    /// The bits of `number` are specialization constants, which this kernel does not have: each
    /// number is another kernel of the same code.
    static KernelInfo kernelOfNumber(uint32_t number) {
        KernelInfo info{.name = "test", .spirv = kSinCosTwoPiSpirv};
        for (const uint32_t index : {0u, 1u})
            info.bindings.push_back(
                {index, vk::DescriptorType::eStorageBuffer, 1, vk::ShaderStageFlagBits::eCompute});
        for (uint32_t bit = 0; bit < 8; ++bit)
            info.constants.push_back(number >> bit & 1u);
        return info;
    }

    std::shared_ptr<const Kernel> get(uint32_t number) {
        return store_.get(testDevice(), kernelOfNumber(number));
    }

    KernelStore store_;
};

TEST_F(KernelStoreTest, CompilesAKernelOnce) {
    const auto first = get(0);
    EXPECT_EQ(get(0), first);
    EXPECT_EQ(store_.size(), 1u);
}

TEST_F(KernelStoreTest, TellsKernelsApart) {
    const auto first = get(0);
    EXPECT_NE(get(1), first);
    KernelInfo other = kernelOfNumber(0);
    other.pushConstantBytes = 16;
    EXPECT_NE(store_.get(testDevice(), other), first);
    other = kernelOfNumber(0);
    other.bindings.push_back(
        {2, vk::DescriptorType::eUniformBuffer, 1, vk::ShaderStageFlagBits::eCompute});
    EXPECT_NE(store_.get(testDevice(), other), first);
    std::vector<uint32_t> code(other.spirv.begin(), other.spirv.end());
    code[3] += 1; // the bound of identifiers
    other = kernelOfNumber(0);
    other.spirv = code;
    EXPECT_NE(store_.get(testDevice(), other), first);
}

TEST_F(KernelStoreTest, DropsTheKernelThatWasUsedLeastRecently) {
    constexpr uint32_t kMost = KernelStore::kMostKernels;
    const auto inUse = get(0);
    const std::weak_ptr<const Kernel> second = get(1);
    const std::weak_ptr<const Kernel> third = get(2);
    for (uint32_t number = 3; number < kMost; ++number)
        get(number);
    get(1); // so that the third one is the oldest
    EXPECT_FALSE(third.expired());
    get(kMost);
    EXPECT_TRUE(third.expired());
    EXPECT_FALSE(second.expired());
    EXPECT_EQ(get(0), inUse);
    EXPECT_EQ(store_.size(), kMost);
}

} // namespace
} // namespace calotype::test
