#include <cmath>
#include <cstring>
#include <limits>

#include <gtest/gtest.h>
#include <zlib.h>

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

#include "base/error.h"
#include "film/write_picture.h"
#include "image/denoised_mark.h"
#include "image/image_check.h"
#include "image/image_format.h"
#include "image/pfm.h"
#include "image/png.h"
#include "support/scratch_folder.h"

namespace calotype {
namespace {

using test::readBytes;
using test::ScratchFolder;
using test::writeBytes;

TEST(ImageFormatTest, IsNamedByTheExtensionInAnyCase) {
    EXPECT_EQ(imageFormatOf("a/b.png"), ImageFormat::Png);
    EXPECT_EQ(imageFormatOf("b.EXR"), ImageFormat::Exr);
    EXPECT_EQ(imageFormatOf("b.old.Pfm"), ImageFormat::Pfm);
    for (const char* unknown : {"b.jpg", "png", ".png", "b.png/c", "b.png.", ""})
        EXPECT_EQ(imageFormatOf(unknown), std::nullopt) << unknown;
}

TEST(PngTest, IsDecodedToTheSamePixels) {
    Rgb8Image image(37, 23);
    for (uint32_t y = 0; y < image.height; ++y)
        for (uint32_t x = 0; x < image.width; ++x)
            image.at(x, y) = {x * 6, y * 11, (x * 31 + y * 57) % 256};
    const ScratchFolder folder;
    writePng(folder / "a.png", image);

    int width = 0, height = 0, channels = 0;
    stbi_uc* pixels = stbi_load((folder / "a.png").c_str(), &width, &height, &channels, 0);
    ASSERT_NE(pixels, nullptr);
    EXPECT_EQ(width, 37);
    EXPECT_EQ(height, 23);
    EXPECT_EQ(channels, 3);
    EXPECT_EQ(std::memcmp(pixels, image.pixels.data(), image.pixels.size() * 3), 0);
    stbi_image_free(pixels);
}

// The chunk of the PNG specification, 11.3.2.5: one byte, 0 for the intent "perceptual", before the
// pixels. Its checksum is that of zlib.
TEST(PngTest, SaysThatItIsSrgb) {
    Rgb8Image image(3, 2);
    const std::string bytes = encodePng(image);
    const std::string name("sRGB\0", 5);
    const size_t at = bytes.find(name);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(bytes.substr(at - 4, 4), std::string("\0\0\0\1", 4));
    EXPECT_EQ(bytes.find("IHDR") + 4 + 13 + 4 + 4, at) << "next to the header and its checksum";
    EXPECT_LT(at, bytes.find("IDAT"));
    uint32_t checksum = 0;
    for (size_t i = 0; i < 4; ++i)
        checksum = checksum << 8 | static_cast<unsigned char>(bytes[at + 5 + i]);
    EXPECT_EQ(checksum, crc32(0, reinterpret_cast<const Bytef*>(name.data()), 5));
}

TEST(PngTest, HoldsAlpha) {
    Rgb8Image image(5, 3);
    std::vector<uint8_t> alpha;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        image.pixels[i] = glm::u8vec3(i, 2 * i, 255 - i);
        alpha.push_back(static_cast<uint8_t>(17 * i));
    }
    const std::string bytes = encodePng(image, {}, alpha);
    int width = 0, height = 0, channels = 0;
    stbi_uc* pixels =
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                              static_cast<int>(bytes.size()), &width, &height, &channels, 0);
    ASSERT_NE(pixels, nullptr);
    EXPECT_EQ(width, 5);
    EXPECT_EQ(height, 3);
    ASSERT_EQ(channels, 4);
    for (size_t i = 0; i < alpha.size(); ++i) {
        EXPECT_EQ(std::memcmp(pixels + 4 * i, &image.pixels[i], 3), 0);
        EXPECT_EQ(pixels[4 * i + 3], alpha[i]);
    }
    stbi_image_free(pixels);
}

// The chunk of the PNG specification, 11.3.3.3: keyword, a zero byte and the text, before the
// pixels. Its checksum is that of zlib.
TEST(PngTest, HoldsTexts) {
    const std::vector<PngText> texts = {{"Software", "Calotype"}, {"calotype:denoiser", "a\tb"}};
    const std::string bytes = encodePng(Rgb8Image(3, 2), texts);
    EXPECT_EQ(checkPng(bytes, "a.png").width, 3u);
    const std::string chunk("tEXtSoftware\0Calotype", 21);
    const size_t at = bytes.find(chunk);
    ASSERT_NE(at, std::string::npos);
    EXPECT_EQ(bytes.substr(at - 4, 4), std::string("\0\0\0\21", 4)) << "17 bytes";
    EXPECT_LT(at, bytes.find("IDAT"));
    uint32_t checksum = 0;
    for (size_t i = 0; i < 4; ++i)
        checksum = checksum << 8 | static_cast<unsigned char>(bytes[at + chunk.size() + i]);
    EXPECT_EQ(checksum, crc32_z(0, reinterpret_cast<const Bytef*>(chunk.data()), chunk.size()));
    const std::vector<PngText> read = pngTexts(bytes);
    ASSERT_EQ(read.size(), 2u);
    EXPECT_EQ(read[0].keyword, "Software");
    EXPECT_EQ(read[0].text, "Calotype");
    EXPECT_EQ(read[1].keyword, "calotype:denoiser");
    EXPECT_EQ(read[1].text, "a?b") << "no control characters";
    EXPECT_TRUE(pngTexts(encodePng(Rgb8Image(3, 2))).empty());
    EXPECT_TRUE(pngTexts(bytes.substr(0, at + 9)).empty()) << "cut off";
}

TEST(DenoisedMarkTest, IsInExrAndPng) {
    const ScratchFolder folder;
    Picture picture{Image(3, 2)};
    for (const char* name : {"a.exr", "a.png", "a.pfm"}) {
        writePicture(folder / name, picture, {});
        EXPECT_FALSE(readMark(folder / name)) << name;
    }
    addMark({"a denoiser 1.2", 0.125, 0.25}, picture.metadata);
    for (const char* name : {"a.exr", "a.png"}) {
        writePicture(folder / name, picture, {});
        const auto mark = readMark(folder / name);
        ASSERT_TRUE(mark) << name;
        EXPECT_EQ(mark->denoiser, "a denoiser 1.2");
        EXPECT_EQ(mark->error, 0.125);
        EXPECT_EQ(mark->bound, 0.25);
    }
    removeMark(picture.metadata);
    addMark({"a denoiser 1.2", {}, {}}, picture.metadata);
    for (const char* name : {"a.exr", "a.png"}) {
        writePicture(folder / name, picture, {});
        ASSERT_TRUE(readMark(folder / name)) << name;
        EXPECT_FALSE(readMark(folder / name)->error) << name;
    }
}

TEST(PngTest, RefusesMorePixelsThanItsEncoderCounts) {
    Rgb8Image image(1, 1);
    image.width = image.height = 30000;
    const ScratchFolder folder;
    try {
        writePng(folder / "a.png", image);
        ADD_FAILURE() << "nothing was thrown";
    } catch (const OutputError& error) {
        EXPECT_NE(std::string(error.what()).find("too many for a PNG"), std::string::npos);
    }
}

TEST(PfmTest, IsLittleEndianFromTheBottomRow) {
    Image image(1, 2);
    image.at(0, 0) = {1.0f, 2.0f, 3.0f};
    image.at(0, 1) = {-4.0f, 5.0f, 6.0f};
    const ScratchFolder folder;
    writePfm(folder / "a.pfm", image);
    const std::string expected("PF\n1 2\n-1.0\n"
                               "\0\0\x80\xc0\0\0\xa0\x40\0\0\xc0\x40"
                               "\0\0\x80\x3f\0\0\0\x40\0\0\x40\x40",
                               12 + 24);
    EXPECT_EQ(readBytes(folder / "a.pfm"), expected);
}

TEST(PfmTest, ComesBackBitForBit) {
    const float infinity = std::numeric_limits<float>::infinity();
    Image image(3, 2);
    image.pixels = {{-1.5f, 1e-30f, 1e30f},
                    {std::nanf("7"), infinity, -infinity},
                    {-0.0f, 1e-42f, 0.1f},
                    {1, 2, 3},
                    {4, 5, 6},
                    {7, 8, 9}};
    const ScratchFolder folder;
    writePfm(folder / "a.pfm", image);
    const Image read = readPfm(folder / "a.pfm");
    ASSERT_EQ(read.width, 3u);
    ASSERT_EQ(read.height, 2u);
    EXPECT_EQ(std::memcmp(read.pixels.data(), image.pixels.data(), 6 * sizeof(glm::vec3)), 0);
}

TEST(PfmTest, ReadsBigEndian) {
    const ScratchFolder folder;
    writeBytes(folder / "a.pfm", std::string("PF 1 1 1.0\n\x3f\x80\0\0\x40\0\0\0\xc0\x40\0\0", 23));
    EXPECT_EQ(readPfm(folder / "a.pfm").at(0, 0), glm::vec3(1.0f, 2.0f, -3.0f));
}

TEST(PfmTest, RefusesWhatIsNotWhole) {
    const ScratchFolder folder;
    EXPECT_THROW(readPfm(folder / "missing.pfm"), SceneError);
    const std::string pixel(12, '\0');
    for (const std::string& bytes :
         {std::string(), std::string("PF\n1 1\n"), "Pf\n1 1\n-1\n" + pixel, "PF\n0 1\n-1\n" + pixel,
          "PF\n1 1\n0\n" + pixel, "PF\n2 1\n-1\n" + pixel, "PF\n1 1\n-1\n" + pixel + "x",
          "PF\n4294967295 4294967295\n-1\n" + pixel}) {
        writeBytes(folder / "a.pfm", bytes);
        EXPECT_THROW(readPfm(folder / "a.pfm"), SceneError) << bytes;
    }
}

} // namespace
} // namespace calotype
