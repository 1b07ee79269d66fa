// Public collections of odd and corrupt images, where ../shared/data has them: each decodes or is
// refused with a sentence, in bounded time and memory.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <random>

#include <gtest/gtest.h>

#include "image/read_texel_image.h"
#include "image/texel_values.h"
#include "scene/texture.h"
#include "support/paths.h"
#include "unit/memory_use.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

namespace fs = std::filesystem;

/// Every test also bounds the memory that it uses.
class ImageCorporaTest : public testing::Test {
protected:
    ~ImageCorporaTest() override { EXPECT_LT(memory_.peak(), kMostMemory); }

private:
    /// Some MiB by itself. Broken copies may claim 2^28 texels, but hold no more than 20 KB, which
    /// deflate can swell to 20 MB.
    static constexpr int64_t kMostMemory = (int64_t{64} << 20) + kSanitizerMemory;

    MemoryGauge memory_;
};

std::vector<fs::path> imagesOf(const std::string& folder) {
    std::vector<fs::path> paths;
    const fs::path root = fs::path(kProjectFolder) / "../shared/data" / folder;
    if (fs::exists(root))
        for (const auto& entry : fs::recursive_directory_iterator(root))
            if (const std::string extension = entry.path().extension();
                extension == ".png" || extension == ".jpg" || extension == ".tga")
                paths.push_back(entry.path());
    std::ranges::sort(paths);
    return paths;
}

TexelImage read(const std::string& bytes) {
    return readTexelImage(bytes, ImageTexture::kLargestSide, "image");
}

TEST_F(ImageCorporaTest, PngsDecodeUnlessCorrupt) {
    const std::vector<fs::path> paths = imagesOf("pngsuite");
    if (paths.empty())
        GTEST_SKIP() << "../shared/data is not there";
    for (const fs::path& path : paths) {
        SCOPED_TRACE(path.filename());
        const bool isCorrupt = path.filename().string().front() == 'x';
        if (isCorrupt)
            EXPECT_THROW(read(readBytes(path)), SceneError);
        else
            EXPECT_NO_THROW(read(readBytes(path)));
    }
}

/// The largest difference of the colours of two images of one size, in units of 1 / 255.
int largestDifference(const TexelImage& a, const TexelImage& b) {
    float largest = 0.0f;
    for (size_t i = 0; i < a.texelCount(); ++i)
        for (int k = 0; k < 3; ++k)
            largest =
                std::max(largest, std::abs(texelComponent(a, i, k) - texelComponent(b, i, k)));
    return static_cast<int>(std::lround(255.0f * largest));
}

TEST_F(ImageCorporaTest, JpegsDecodeToThePngBesideThem) {
    // libjpeg, which made the PNGs, does not smooth chroma that is one or two samples wide.
    constexpr uint32_t kNarrow = 4;
    constexpr int kTolerance = 3; // two roundings of the transform and one of the colours
    // Lacks the scan of its blocks' means, so that every decoder shows something else.
    constexpr const char* kWithoutMean = "progressive-missing-dc.jpg";
    std::vector<std::string> refused;
    size_t compared = 0;
    for (fs::path path : imagesOf("jpeg-conformance")) {
        if (path.extension() != ".jpg")
            continue;
        SCOPED_TRACE(path.filename());
        const TexelImage png = read(readBytes(fs::path(path).replace_extension(".png")));
        try {
            const TexelImage jpeg = read(readBytes(path));
            EXPECT_EQ(jpeg.width, png.width);
            ASSERT_EQ(jpeg.texelCount(), png.texelCount());
            if (png.width > kNarrow && path.filename() != kWithoutMean)
                EXPECT_LE(largestDifference(jpeg, png), kTolerance);
            ++compared;
        } catch (const SceneError&) {
            refused.push_back(path.filename());
        }
    }
    if (compared == 0 && refused.empty())
        GTEST_SKIP() << "../shared/data is not there";
    EXPECT_GT(compared, 0);
    EXPECT_EQ(refused, (std::vector<std::string>{"partial_progressive.jpg"}));
}

TEST_F(ImageCorporaTest, TgasOfEqualContentAreEqual) {
    const std::vector<fs::path> paths = imagesOf("tga-basic");
    if (paths.empty())
        GTEST_SKIP() << "../shared/data is not there";
    for (const fs::path& path : paths)
        EXPECT_NO_THROW(read(readBytes(path))) << path;
    const fs::path folder = paths.front().parent_path();
    EXPECT_EQ(read(readBytes(folder / "tga_compressed.tga")).bytes,
              read(readBytes(folder / "tga_uncompressed.tga")).bytes);
}

TEST_F(ImageCorporaTest, BrokenCopiesAreDecodedOrRefused) {
    constexpr int kCopies = 12;
    constexpr size_t kLargestFile = 20'000;
    std::mt19937 random(1);
    size_t tried = 0;
    const double seconds = processorSeconds([&] {
        for (const char* folder : {"pngsuite", "jpeg-conformance", "tga-basic"}) {
            for (const fs::path& path : imagesOf(folder)) {
                const std::string original = readBytes(path).substr(0, kLargestFile);
                for (int copy = 0; copy < kCopies; ++copy) {
                    std::string bytes = original;
                    const int changes = 1 + copy % 4;
                    for (int i = 0; i < changes; ++i)
                        bytes[random() % bytes.size()] = static_cast<char>(random());
                    if (copy % 3 == 0)
                        bytes.resize(random() % bytes.size());
                    try {
                        const TexelImage image = read(bytes);
                        EXPECT_EQ(4 * image.texelCount(), image.bytes.size() + image.floats.size());
                    } catch (const SceneError& error) {
                        EXPECT_EQ(error.where(), "image");
                    }
                    ++tried;
                }
            }
        }
    });
    if (tried == 0)
        GTEST_SKIP() << "../shared/data is not there";
    EXPECT_LT(seconds, 120.0); // a few by itself, ten times that under sanitizers
}

} // namespace
} // namespace calotype::test
