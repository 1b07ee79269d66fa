// The largest texture that is accepted, made on the fly, and the first that is not.

#include <algorithm>

#include <gtest/gtest.h>

#include "image/read_texel_image.h"
#include "scene/texture.h"
#include "support/slow_run.h"
#include "unit/memory_use.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSide = ImageTexture::kLargestSide;

void appendLittleEndian16(std::string& bytes, uint32_t value) {
    bytes += {static_cast<char>(value), static_cast<char>(value >> 8)};
}

/// A run-length encoded TGA of the colour (R, G, B) = (3, 2, 1) but for its last texel of (6, 5,
/// 4), which is at the bottom right.
std::string largeTga(uint32_t width, uint32_t height) {
    constexpr uint32_t kLongestRun = 128;
    std::string bytes{0, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0};
    appendLittleEndian16(bytes, width);
    appendLittleEndian16(bytes, height);
    bytes += {24, 0x20}; // bits per texel; rows from the top
    uint64_t left = uint64_t{width} * height - 1;
    for (; left > 0; left -= std::min<uint64_t>(left, kLongestRun)) {
        const auto run = static_cast<char>(std::min<uint64_t>(left, kLongestRun) - 1);
        bytes += {static_cast<char>(run | 0x80), 1, 2, 3};
    }
    return bytes += {0, 4, 5, 6};
}

// The quick run reads a sixteenth of it: memory takes most of the time.
TEST(LargestTextureTest, OfSixteenThousandTexelsSquaredIsRead) {
    const uint32_t height = quickOrFull(kSide / 16, kSide);
    const std::string file = largeTga(kSide, height);
    TexelImage image;
    const MemoryGauge memory;
    const double seconds =
        processorSeconds([&] { image = readTexelImage(file, kSide, "large.tga"); });
    ASSERT_EQ(image.width, kSide);
    ASSERT_EQ(image.height, height);
    const size_t count = size_t{4} * kSide * height;
    ASSERT_EQ(image.bytes.size(), count);
    const std::vector<uint8_t> first(image.bytes.begin(), image.bytes.begin() + 4);
    const std::vector<uint8_t> last(image.bytes.end() - 4, image.bytes.end());
    EXPECT_EQ(first, (std::vector<uint8_t>{3, 2, 1, 255}));
    EXPECT_EQ(last, (std::vector<uint8_t>{6, 5, 4, 255}));
    EXPECT_TRUE(std::equal(image.bytes.begin() + 4, image.bytes.end() - 4, image.bytes.begin()))
        << "the other texels differ";
    EXPECT_FALSE(image.isTransparent);
    EXPECT_LT(seconds, 120.0); // four by itself, more under sanitizers
    // The texels, without a copy: 1 GiB of 1150 MiB in the slow run.
    EXPECT_LT(memory.peak(), static_cast<int64_t>(count / 1024 * 1150) + kSanitizerMemory);
}
ALSO_SLOW_TEST(LargestTextureTest, OfSixteenThousandTexelsSquaredIsRead);

TEST(LargestTextureTest, OfOneTexelMoreIsRefused) {
    for (const auto& [width, height] : {std::pair(kSide + 1, 1u), std::pair(1u, kSide + 1)}) {
        const std::string file = largeTga(width, height);
        const SceneError error = errorOf([&] { readTexelImage(file, kSide, "large.tga"); });
        EXPECT_NE(std::string(error.what()).find("largest side of 16384"), std::string::npos)
            << error.what();
    }
}

} // namespace
} // namespace calotype::test
