// Copies to the device.
#include <numeric>

#include "support/gpu_test.h"

namespace calotype::test {
namespace {

using BufferTest = GpuTest;

TEST_F(BufferTest, StagingCopiesPieceByPiece) {
    std::vector<uint32_t> contents(1000);
    std::iota(contents.begin(), contents.end(), 7u);
    for (const size_t stagingBytes : {64, 1024, 4000, 10000}) {
        const Buffer buffer(testDevice(), 4000, vk::BufferUsageFlagBits::eTransferDst,
                            Buffer::Memory::Host, "copied");
        copyByStaging(testDevice(), std::as_bytes(std::span(contents)), buffer, stagingBytes);
        EXPECT_TRUE(std::ranges::equal(buffer.mapped<uint32_t>(), contents)) << stagingBytes;
    }
}

TEST_F(BufferTest, IsClearedWhole) {
    const Buffer buffer(testDevice(), 4000, vk::BufferUsageFlagBits::eTransferDst,
                        Buffer::Memory::Host, "cleared");
    std::ranges::fill(buffer.mapped<uint32_t>(), 7u);
    clear(testDevice(), buffer);
    EXPECT_EQ(std::ranges::count(buffer.mapped<uint32_t>(), 0u), 1000);
}

} // namespace
} // namespace calotype::test
