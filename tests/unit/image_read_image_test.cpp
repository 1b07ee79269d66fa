// Pictures of every kind as linear light, and the refusal of what is none.
#include "image/read_image.h"

#include <cstring>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include "base/error.h"
#include "image/exr.h"
#include "image/pfm.h"
#include "support/image_files.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using namespace std::string_literals;

using test::pngFile;
using test::pngOf;
using test::readBytes;
using test::ScratchFolder;
using test::writeBytes;

class ReadImageTest : public testing::Test {
protected:
    Image read(const std::string& bytes) const {
        writeBytes(folder_ / "picture", bytes);
        return readImage(folder_ / "picture");
    }

    void expectFileRefused(const std::filesystem::path& path, const std::string& fragment) const {
        try {
            readImage(path);
            ADD_FAILURE() << "nothing was thrown; expected: " << fragment;
        } catch (const SceneError& error) {
            EXPECT_EQ(error.where(), path.string());
            EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos)
                << error.what() << "\ndoes not say: " << fragment;
        }
    }

    void expectRefused(const std::string& bytes, const std::string& fragment) const {
        writeBytes(folder_ / "picture", bytes);
        expectFileRefused(folder_ / "picture", fragment);
    }

    std::string exrOf(const Image& image) const {
        writeExr(folder_ / "a.exr", {image});
        return readBytes(folder_ / "a.exr");
    }

    ScratchFolder folder_;
};

Image twoByTwo() {
    Image image(2, 2);
    image.pixels = {{0.25f, 1.5f, -2.0f}, {3, 4, 5}, {6, 7, 8}, {9, 10, 11}};
    return image;
}

TEST_F(ReadImageTest, TakesFloatsAsTheyAre) {
    const Image image = twoByTwo();
    writePfm(folder_ / "a.pfm", image);
    for (const std::string& bytes : {exrOf(image), readBytes(folder_ / "a.pfm")}) {
        const Image copy = read(bytes); // its name says nothing of its kind
        EXPECT_EQ(copy.width, 2u);
        EXPECT_EQ(copy.height, 2u);
        EXPECT_EQ(copy.pixels, image.pixels);
    }
}

TEST_F(ReadImageTest, DecodesRgbeButNoCurve) {
    const Image image = read("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 2 +X 1\n"
                             "\x80\x40\x20\x81\x80\x80\x80\0"s);
    ASSERT_EQ(image.pixels.size(), 2u);
    EXPECT_EQ(image.at(0, 0), glm::vec3(1.0f, 0.5f, 0.25f));
    EXPECT_EQ(image.at(0, 1), glm::vec3(0.0f));
}

// The expected values are those of IEC 61966-2-1, to seven digits.
TEST_F(ReadImageTest, DecodesPngsFromSrgb) {
    const Image bytes = read(pngOf(2, 1, {{0, 10, 11, 7}, {128, 188, 255, 255}}));
    ASSERT_EQ(bytes.pixels.size(), 2u);
    constexpr float kTolerance = 3e-7f; // of the float power and of the digits given here
    EXPECT_EQ(bytes.at(0, 0).r, 0.0f);
    EXPECT_NEAR(bytes.at(0, 0).g, 0.00303527f, 1e-8f); // on the line, 10 / 255 / 12.92
    EXPECT_NEAR(bytes.at(0, 0).b, 0.00334654f, 1e-8f); // on the curve
    EXPECT_NEAR(bytes.at(1, 0).r, 0.2158605f, kTolerance);
    EXPECT_NEAR(bytes.at(1, 0).g, 0.5028865f, kTolerance);
    EXPECT_EQ(bytes.at(1, 0).b, 1.0f);

    // 16 bits of RGB: 0x8000, 0xffff and 1 of 65535.
    const Image words = read(pngFile(1, 1, 16, 2, "\0\x80\0\xff\xff\0\x01"s));
    ASSERT_EQ(words.pixels.size(), 1u);
    EXPECT_NEAR(words.at(0, 0).r, 0.2140482f, kTolerance);
    EXPECT_EQ(words.at(0, 0).g, 1.0f);
    EXPECT_NEAR(words.at(0, 0).b, 1.0f / 65535.0f / 12.92f, 1e-12f);
}

TEST_F(ReadImageTest, RefusesWhatIsNoFile) {
    expectFileRefused(folder_ / "missing.exr", "check that it exists");
    expectFileRefused(folder_.path(), "not a regular file");
    ASSERT_EQ(mkfifo((folder_ / "pipe.pfm").c_str(), 0600), 0);
    expectFileRefused(folder_ / "pipe.pfm", "not a regular file");
    expectFileRefused(std::filesystem::path("/dev/zero"), "not a regular file");
}

TEST_F(ReadImageTest, RefusesOtherKinds) {
    for (const std::string& bytes :
         {std::string(), std::string("P"), std::string("P6\n1 1\n255\nabc"), std::string(100, '\0'),
          std::string("\xff\xd8\xff\xe0....JFIF"), std::string("{ \"camera\": {} }")})
        expectRefused(bytes, "EXR, PFM (colour), HDR and PNG can be compared");
    expectRefused("Pf\n1 1\n-1\n1234", "PFM (colour)");
}

TEST_F(ReadImageTest, RefusesWhatIsDamaged) {
    writePfm(folder_ / "a.pfm", twoByTwo());
    const std::string pfm = readBytes(folder_ / "a.pfm");
    expectRefused(pfm.substr(0, pfm.size() - 1), "not 2 x 2 pixels");
    const std::string png = pngOf({1, 2, 3, 255});
    expectRefused(png.substr(0, png.size() - 1), "incomplete");
    expectRefused("#?RADIANCE\n\n-Y 2 +X 2\nabcd", "incomplete");
    const std::string exr = exrOf(twoByTwo());
    expectRefused(exr.substr(0, exr.size() - 1), "EXR file cannot be read");
    expectRefused(exr.substr(0, 20), "EXR file cannot be read");
    std::string noChannel = exr;
    noChannel[noChannel.find("G\0\2"s)] = 'H';
    expectRefused(noChannel, "no full-size channel G");
}

/// The same EXR with a data window of other corners.
std::string withDataWindow(std::string exr, int32_t lastX, int32_t lastY) {
    const std::string name = "dataWindow\0box2i\0\x10\0\0\0"s;
    const size_t window = exr.find(name) + name.size();
    std::memcpy(&exr[window + 8], &lastX, sizeof lastX);
    std::memcpy(&exr[window + 12], &lastY, sizeof lastY);
    return exr;
}

TEST_F(ReadImageTest, RefusesMorePixelsThanItTakes) {
    const std::string exr = exrOf(twoByTwo());
    EXPECT_EQ(read(withDataWindow(exr, 1, 1)).pixels, twoByTwo().pixels); // the name is found
    expectRefused(withDataWindow(exr, 65535, 1), "largest side of 65535");
    expectRefused(withDataWindow(exr, 65534, 1 << 30), "cannot be read");
    expectRefused(pngFile(65536, 1, 8, 2, ""), "largest side of 65535");
    expectRefused(pngFile(16385, 16384, 8, 2, ""), "that can be compared; cut a part out of it");
    const std::string pixels(size_t{65536} * 12, '\0');
    expectRefused("PF\n65536 1\n-1\n" + pixels, "largest side of 65535");
    expectRefused("PF\n1 65536\n-1\n" + pixels, "largest side of 65535");

    // A sparse file, of which nothing is read.
    writeBytes(folder_ / "large.pfm", "PF\n1 1\n-1\n");
    std::filesystem::resize_file(folder_ / "large.pfm", uintmax_t{1} << 32);
    expectFileRefused(folder_ / "large.pfm", "larger than 3 GiB");
}

// A few bytes claim to be three GiB of pixels.
TEST_F(ReadImageTest, ClaimsOfManyPixelsTakeNoMemory) {
    const auto peakKilobytes = [] {
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        return usage.ru_maxrss;
    };
    const std::string tableOfOffsets(size_t{16384} / 16 * 8, '\0'); // 8 bytes for every 16 rows
    const std::string exr = exrOf(twoByTwo()) + tableOfOffsets;
    const long before = peakKilobytes();
    expectRefused(withDataWindow(exr, 16383, 16383), "EXR file cannot be read");
    expectRefused("PF\n16384 16384\n-1\nabc", "bytes of pixels");
    expectRefused("#?RADIANCE\n\n-Y 16384 +X 16384\nabc", "incomplete");
    constexpr long kSlackKilobytes = 100'000; // a row of blocks, and what allocators keep
    EXPECT_LT(peakKilobytes() - before, kSlackKilobytes);
}

} // namespace
} // namespace calotype
