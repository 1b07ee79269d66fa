// Copies to the device.
#include <array>
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
        const auto bytes = std::as_bytes(std::span(contents));
        copyByStaging(testDevice(), BufferParts(&bytes, 1), buffer, stagingBytes);
        EXPECT_TRUE(std::ranges::equal(buffer.mapped<uint32_t>(), contents)) << stagingBytes;
    }
}

// Parts of 5, 1 and 8 words start at words 0, 8 and 12.
TEST_F(BufferTest, PartsStartAtRows) {
    std::vector<uint32_t> contents(14);
    std::iota(contents.begin(), contents.end(), 1u);
    const auto bytes = std::as_bytes(std::span(contents));
    const std::array parts = {bytes.first(20), bytes.subspan(20, 4), bytes.subspan(24)};
    for (const size_t stagingBytes : {4, 12, 16, 40, 1000}) {
        const Buffer buffer(testDevice(), 80, vk::BufferUsageFlagBits::eTransferDst,
                            Buffer::Memory::Host, "parts");
        copyByStaging(testDevice(), parts, buffer, stagingBytes);
        const auto words = buffer.mapped<uint32_t>();
        for (size_t i = 0; i < contents.size(); ++i)
            EXPECT_EQ(words[i < 5 ? i : i < 6 ? 8 : i + 6], contents[i]) << stagingBytes;
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
