// Image files of every kind to texels, and the refusal of what is none.

#include <malloc.h>

#include <gtest/gtest.h>

#include "image/read_texel_image.h"
#include "image/texel_values.h"
#include "support/image_files.h"
#include "unit/texel_reading.h"

namespace calotype::test {
namespace {

/// Four texels: red and green above, blue and a grey below.
const std::vector<Rgba8> kTexels = {
    {255, 0, 0, 255}, {0, 200, 0, 255}, {0, 0, 100, 255}, {77, 77, 77, 255}};

void expectTexels(const TexelImage& image, int tolerance) {
    ASSERT_EQ(image.width, 2u);
    ASSERT_EQ(image.height, 2u);
    ASSERT_EQ(image.bytes.size(), 16u);
    EXPECT_TRUE(image.floats.empty());
    EXPECT_TRUE(image.isEncoded);
    for (size_t i = 0; i < 4; ++i)
        for (size_t k = 0; k < 4; ++k)
            EXPECT_NEAR(image.bytes[4 * i + k], kTexels[i][k], tolerance) << i << " " << k;
}

TEST(ReadTexelImageTest, ReadsPngBmpAndTgaExactly) {
    std::string bmp;
    std::string tga;
    std::string flatTga;
    stbi_write_bmp_to_func(appendTo, &bmp, 2, 2, 4, kTexels.data());
    stbi_write_tga_to_func(appendTo, &tga, 2, 2, 4, kTexels.data());
    stbi_write_tga_with_rle = 0;
    stbi_write_tga_to_func(appendTo, &flatTga, 2, 2, 4, kTexels.data());
    stbi_write_tga_with_rle = 1;
    for (const std::string& file : {pngOf(2, 2, kTexels), bmp, tga, flatTga}) {
        const TexelImage image = read(file);
        expectTexels(image, 0);
        EXPECT_FALSE(image.isTransparent);
        for (size_t cut = 1; cut < 8; ++cut)
            expectRefused(file.substr(0, file.size() - cut), "incomplete");
    }
}

/// A BMP of one pixel of 32 bits with a header of `headerSize` bytes, 40 or more.
std::string bmp32(uint32_t headerSize, uint32_t compression, const std::vector<uint32_t>& masks,
                  const std::string& pixel) {
    std::string fields;
    const auto append = [&](uint32_t value, int bytes = 4) {
        for (int i = 0; i < bytes; ++i)
            fields += static_cast<char>(value >> (8 * i));
    };
    for (const uint32_t value : {headerSize, 1u, 1u})
        append(value);
    append(1, 2);
    append(32, 2);
    for (const uint32_t value : {compression, 4u, 0u, 0u, 0u, 0u})
        append(value);
    for (const uint32_t mask : masks)
        append(mask);
    if (headerSize > fields.size())
        fields.resize(headerSize);
    const auto offset = static_cast<char>(14 + fields.size());
    return "BM" + std::string(8, '\0') + std::string{offset, 0, 0, 0} + fields + pixel;
}

// Microsoft's "BITMAPINFOHEADER": with BI_RGB (0) "the high byte in each DWORD is not used". With
// BI_BITFIELDS (3) the mask of alpha counts, which only headers of 56 bytes and more have.
TEST(ReadTexelImageTest, FourthByteOfABmpIsAlphaOnlyIfAMaskSaysSo) {
    const std::vector<uint32_t> colors = {0xff0000, 0xff00, 0xff};
    const std::vector<uint32_t> all = {0xff0000, 0xff00, 0xff, 0xff000000};
    const std::string pixel = "\x0a\x14\xc8\x0a"; // blue, green, red and 10
    const std::pair<std::string, uint8_t> files[] = {
        {bmp32(40, 0, {}, pixel), 255},   {bmp32(40, 3, colors, pixel), 255},
        {bmp32(108, 0, all, pixel), 255}, {bmp32(108, 3, colors, pixel), 255},
        {bmp32(108, 3, all, pixel), 10},  {bmp32(52, 3, colors, pixel), 255},
        {bmp32(56, 0, all, pixel), 255},  {bmp32(56, 3, all, pixel), 10}};
    for (const auto& [file, alpha] : files) {
        const TexelImage image = read(file);
        EXPECT_EQ(image.bytes, (std::vector<uint8_t>{200, 20, 10, alpha}));
        EXPECT_EQ(image.isTransparent, alpha < 255);
    }
}

TEST(ReadTexelImageTest, ReadsJpegNearly) {
    // One colour, since sharp ones blur.
    std::string jpeg;
    const std::vector<Rgba8> grey(64, Rgba8{77, 77, 77, 255});
    stbi_write_jpg_to_func(appendTo, &jpeg, 8, 8, 4, grey.data(), 100);
    const TexelImage image = read(jpeg);
    ASSERT_EQ(image.bytes.size(), 4u * 64u);
    for (size_t i = 0; i < image.bytes.size(); ++i)
        EXPECT_NEAR(image.bytes[i], i % 4 == 3 ? 255 : 77, 1);
    EXPECT_TRUE(image.isEncoded);
    for (const size_t cut : {size_t{1}, size_t{2}, size_t{20}, jpeg.size() - 30})
        expectRefused(jpeg.substr(0, jpeg.size() - cut), "JPEG is corrupt");
}

TEST(ReadTexelImageTest, KeepsSixteenBits) {
    // Grey and alpha: 0x0102 of 0xffff, and 0x8000 of alpha 0x00ff.
    const std::string rows("\0\x01\x02\xff\xff\x80\x00\x00\xff", 9);
    const TexelImage image = read(pngFile(2, 1, 16, 4, rows));
    ASSERT_EQ(image.floats.size(), 8u);
    EXPECT_TRUE(image.bytes.empty());
    EXPECT_TRUE(image.isEncoded);
    EXPECT_TRUE(image.isTransparent);
    const std::vector<uint32_t> expected = {0x0102, 0x0102, 0x0102, 0xffff,
                                            0x8000, 0x8000, 0x8000, 0x00ff};
    for (size_t i = 0; i < 8; ++i)
        EXPECT_EQ(image.floats[i], static_cast<float>(expected[i]) / 65535.0f) << i;
}

TEST(ReadTexelImageTest, FindsWhetherAnythingIsTransparent) {
    EXPECT_FALSE(read(pngOf({1, 2, 3, 255})).isTransparent);
    EXPECT_TRUE(read(pngOf({1, 2, 3, 254})).isTransparent);
}

TEST(ReadTexelImageTest, RefusesHuffmanTablesThatOverflow) {
    std::string jpeg;
    const std::vector<Rgba8> grey(64, Rgba8{77, 77, 77, 255});
    stbi_write_jpg_to_func(appendTo, &jpeg, 8, 8, 4, grey.data(), 100);
    // A segment of one table with 16 times 17 codes, whose bytes are all there.
    const std::string segment = "\xff\xc4\x01\x23" + std::string(1, '\0') +
                                std::string(16, '\x11') + std::string(16 * 17, '\0');
    expectRefused(jpeg.substr(0, 2) + segment + jpeg.substr(2), "malformed");
}

TEST(ReadTexelImageTest, ReadsNoMemoryThatWasNeverWritten) {
    // A JPEG that has lost its Huffman tables: whatever malloc returns stood in for them.
    std::string jpeg;
    const std::vector<Rgba8> grey(64, Rgba8{77, 77, 77, 255});
    stbi_write_jpg_to_func(appendTo, &jpeg, 8, 8, 4, grey.data(), 100);
    for (size_t at = jpeg.find("\xff\xc4"); at != jpeg.npos; at = jpeg.find("\xff\xc4"))
        jpeg.erase(at, 2 + (static_cast<unsigned char>(jpeg.at(at + 2)) << 8 |
                            static_cast<unsigned char>(jpeg.at(at + 3))));
    for (const int fill : {0x01, 0x55}) {
        ::mallopt(M_PERTURB, fill);
        EXPECT_NO_THROW(EXPECT_EQ(read(jpeg).bytes.at(0), 128)) << fill;
    }
    ::mallopt(M_PERTURB, 0);
}

TEST(ReadTexelImageTest, RefusesWhatIsNoImage) {
    for (const std::string& file :
         {std::string(), std::string("x"), std::string(100, '\0'), std::string("GIF89a\1\0\1\0"),
          std::string("RIFF....WEBPVP8 "), std::string("newmtl a\nKd 1 1 1\nmap_Kd a.png\n"),
          std::string("\x89PNG\r\n\x1a\r\n and so on ....")})
        expectRefused(file, "PNG, JPEG, TGA, BMP and HDR");
}

TEST(ReadTexelImageTest, NamesTheKindOfWhatItCannotRead) {
    using namespace std::string_literals;
    const std::pair<std::string, const char*> files[] = {
        {"DDS |..."s, "a DDS image"},
        {"II*\0...."s, "a TIFF image"},
        {"MM\0*...."s, "a TIFF image"},
        {"RIFF....WEBPVP8 "s, "a WebP image"},
        {"GIF89a\1\0"s, "a GIF image"},
        {"8BPS\0\1"s, "a Photoshop document"},
        {"\x76\x2f\x31\x01\2\0\0\0"s, "an EXR picture"},
        {"\xabKTX 20\xbb"s, "a KTX texture"},
        {"\0\0\0\x1c"
         "ftypavif"s,
         "an AVIF image"},
        {"<!DOCTYPE html><title>404</title>"s, "a web page"},
        {"version https://git-lfs.github.com/spec/v1\n"s, "a Git LFS pointer"},
        {""s, "an empty file"},
    };
    for (const auto& [file, kind] : files)
        expectRefused(file, "the file is "s + kind);
}

TEST(ReadTexelImageTest, LimitsSidesBeforeDecoding) {
    // The rows are missing; only the header counts.
    for (const auto& [width, height] : {std::pair(65u, 1u), std::pair(1u, 65u)})
        expectRefused(pngFile(width, height, 8, 6, ""), "64; scale it down");
    expectRefused(pngFile(0xffffffffu, 0xffffffffu, 8, 6, ""), "4294967295 x 4294967295");
    for (const auto& [width, height] : {std::pair(0u, 1u), std::pair(1u, 0u)})
        expectRefused(pngFile(width, height, 8, 6, ""), "no pixels");
    EXPECT_EQ(read(pngFile(64, 1, 1, 0, std::string(9, '\0'))).width, 64u);
}

TEST(ReadTexelImageTest, PngsMustBeWhole) {
    const std::string file = pngOf(2, 2, kTexels);
    // Any bit of the image's data or size may be the wrong one.
    for (size_t at = 8; at < file.size(); ++at) {
        std::string broken = file;
        broken[at] = static_cast<char>(broken[at] ^ 4);
        EXPECT_THROW(read(broken), SceneError) << at;
    }
    expectTexels(read(file + "trailing bytes"), 0);
    // A bad checksum of what is not needed is no matter.
    std::string comment = pngChunk("tEXt", "Comment");
    comment.back() = static_cast<char>(comment.back() + 1);
    expectTexels(read(file.substr(0, 33) + comment + file.substr(33)), 0);
}

TEST(ReadTexelImageTest, ClaimsOfMuchDataTakeNoMemory) {
    // 100 MB of zeros pack into 100 kB; as one row of an image of 1 x 1 they are refused.
    std::string blocks = "\x78\x01";
    std::string png = pngFile(1, 1, 8, 0, std::string(2, '\0'));
    const std::string bomb = [] {
        // A final block of fixed codes: literal 0, then matches of length 258 at distance 1.
        std::vector<bool> bits = {true, true, false};
        const auto code = [&](uint32_t value, int length) {
            for (int i = length - 1; i >= 0; --i)
                bits.push_back((value >> i & 1u) != 0);
        };
        code(0x30, 8);
        for (int i = 0; i < 400'000; ++i) {
            code(0xc5, 8); // length 258
            code(0, 5);    // distance 1
        }
        code(0, 7);
        std::string bytes((bits.size() + 7) / 8, '\0');
        for (size_t i = 0; i < bits.size(); ++i)
            bytes[i / 8] = static_cast<char>(bytes[i / 8] | (bits[i] ? 1 << i % 8 : 0));
        return bytes;
    }();
    const std::string file =
        png.substr(0, 33) + pngChunk("IDAT", blocks + bomb + "....") + pngChunk("IEND", "");
    expectRefused(file, "outofmem");
}

TEST(ChannelImageTest, TakesOneChannel) {
    const TexelImage image = read(pngOf({10, 20, 30, 40}, 1));
    EXPECT_EQ(greyImage(image, TexelChannel::Green).bytes, (std::vector<uint8_t>{20, 20, 20, 255}));
    EXPECT_EQ(alphaImage(image, TexelChannel::Alpha).bytes,
              (std::vector<uint8_t>{255, 255, 255, 40}));
    EXPECT_TRUE(alphaImage(image, TexelChannel::Alpha).isTransparent);
    EXPECT_FALSE(greyImage(image, TexelChannel::Green).isTransparent);
    // 0.2126 * 10 + 0.7152 * 20 + 0.0722 * 30 = 18.6
    EXPECT_EQ(greyImage(image, TexelChannel::Luminance).bytes[0], 19);
}

} // namespace
} // namespace calotype::test
