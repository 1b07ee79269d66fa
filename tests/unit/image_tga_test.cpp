// TGAs to texels, by the words of Truevision's specification 2.0.

#include <gtest/gtest.h>

#include "image/read_texel_image.h"
#include "unit/scene_files.h"

namespace calotype::test {
namespace {

using Bytes = std::vector<uint8_t>;

/// A TGA of two columns and two rows.
struct Tga {
    int type;
    int bits;
    std::string pixels;
    int descriptor = 0; ///< bits of alpha, 0x10 from the right, 0x20 from the top
    std::string colorMap = {};
    int mapFirst = 0;
    int mapLength = 0;
    int mapBits = 0;
    std::string end = {};

    std::string file() const {
        const auto byte = [](int value) { return static_cast<char>(value); };
        std::string bytes = {2,          byte(mapLength > 0 ? 1 : 0),
                             byte(type), byte(mapFirst),
                             0,          byte(mapLength),
                             0,          byte(mapBits),
                             0,          0,
                             0,          0,
                             2,          0,
                             2,          0,
                             byte(bits), byte(descriptor)};
        return bytes + "id" + colorMap + pixels + end;
    }
};

TexelImage read(const Tga& tga) { return readTexelImage(tga.file(), 64, "image"); }

void expectRefused(const Tga& tga, const std::string& fragment) {
    const SceneError error = errorOf([&] { read(tga); });
    EXPECT_NE(std::string(error.what()).find(fragment), std::string::npos) << error.what();
}

/// Blue, green, red and alpha of four pixels.
const std::string kFour("\1\2\3\x0a\4\5\6\x14\7\x08\x09\x1e\x0a\x0b\x0c\x28", 16);

TEST(ReadTgaTest, AlphaIsThatOfTheHeadersBits) {
    const TexelImage with = read({2, 32, kFour, 0x28});
    EXPECT_EQ(with.bytes, (Bytes{3, 2, 1, 10, 6, 5, 4, 20, 9, 8, 7, 30, 12, 11, 10, 40}));
    EXPECT_TRUE(with.isTransparent);
    EXPECT_TRUE(with.isEncoded);
    const TexelImage without = read({2, 32, kFour, 0x20});
    EXPECT_EQ(without.bytes, (Bytes{3, 2, 1, 255, 6, 5, 4, 255, 9, 8, 7, 255, 12, 11, 10, 255}));
    EXPECT_FALSE(without.isTransparent);
}

TEST(ReadTgaTest, RowsStartAtAnyCorner) {
    const std::string grey = "\1\2\3\4";
    const auto reds = [&](int descriptor) {
        const TexelImage image = read({3, 8, grey, descriptor});
        return Bytes{image.bytes[0], image.bytes[4], image.bytes[8], image.bytes[12]};
    };
    EXPECT_EQ(reds(0x20), (Bytes{1, 2, 3, 4}));
    EXPECT_EQ(reds(0x30), (Bytes{2, 1, 4, 3}));
    EXPECT_EQ(reds(0x00), (Bytes{3, 4, 1, 2}));
    EXPECT_EQ(reds(0x10), (Bytes{4, 3, 2, 1}));
    expectRefused({3, 8, grey, 0x60}, "interleaved");
}

TEST(ReadTgaTest, SixteenBitsAreFiveOfEachColourAndOneOfAlpha) {
    // Red 31; green 16 and alpha; blue 1; white and alpha.
    const std::string words("\x00\x7c\x00\x82\x01\x00\xff\xff", 8);
    // 16 / 31 of 255 is 131.6, and 1 / 31 is 8.2.
    EXPECT_EQ(read({2, 16, words, 0x21}).bytes,
              (Bytes{255, 0, 0, 0, 0, 132, 0, 255, 0, 0, 8, 0, 255, 255, 255, 255}));
    const Bytes opaque = {255, 0, 0, 255, 0, 132, 0, 255, 0, 0, 8, 255, 255, 255, 255, 255};
    EXPECT_EQ(read({2, 16, words, 0x20}).bytes, opaque);
    EXPECT_EQ(read({2, 15, words, 0x21}).bytes, opaque);
}

TEST(ReadTgaTest, GreyMayHaveAlpha) {
    const std::string pairs("\x01\x0a\x02\x14\x03\x1e\x04\x28", 8);
    EXPECT_EQ(read({3, 16, pairs, 0x28}).bytes,
              (Bytes{1, 1, 1, 10, 2, 2, 2, 20, 3, 3, 3, 30, 4, 4, 4, 40}));
    expectRefused({3, 16, pairs, 0x20}, "16 bits without alpha");
}

TEST(ReadTgaTest, ColourMapsStartAtTheirFirstIndex) {
    const std::string map("\1\2\3\4\5\6", 6);
    const Bytes expected = {3, 2, 1, 255, 6, 5, 4, 255, 6, 5, 4, 255, 3, 2, 1, 255};
    EXPECT_EQ(read({1, 8, std::string("\0\1\1\0", 4), 0x20, map, 0, 2, 24}).bytes, expected);
    EXPECT_EQ(read({1, 8, "\5\6\6\5", 0x20, map, 5, 2, 24}).bytes, expected);
    EXPECT_EQ(read({1, 16, std::string("\5\0\6\0\6\0\5\0", 8), 0x20, map, 5, 2, 24}).bytes,
              expected);
    expectRefused({1, 8, "\5\6\7\5", 0x20, map, 5, 2, 24}, "its colour map does not have");
    expectRefused({1, 8, "\5\6\4\5", 0x20, map, 5, 2, 24}, "its colour map does not have");
    // Maps of 32 bits have alpha, if the header counts its bits; other images may have unused maps.
    const std::string deep("\1\2\3\x0a", 4);
    EXPECT_EQ(read({1, 8, std::string(4, '\0'), 0x28, deep, 0, 1, 32}).bytes[3], 10);
    EXPECT_EQ(read({1, 8, std::string(4, '\0'), 0x20, deep, 0, 1, 32}).bytes[3], 255);
    EXPECT_EQ(read({3, 8, "\1\2\3\4", 0x20, map, 0, 2, 24}).bytes[0], 1);
}

TEST(ReadTgaTest, RunsRepeatPixelsOfEveryKind) {
    // One pixel three times, across the end of a row, and one by itself.
    const std::string runs("\x82\1\2\3\x0a\0\4\5\6\x14", 10);
    EXPECT_EQ(read({10, 32, runs, 0x28}).bytes,
              (Bytes{3, 2, 1, 10, 3, 2, 1, 10, 3, 2, 1, 10, 6, 5, 4, 20}));
    EXPECT_EQ(read({10, 32, runs, 0x38}).bytes,
              (Bytes{3, 2, 1, 10, 3, 2, 1, 10, 6, 5, 4, 20, 3, 2, 1, 10}));
    EXPECT_EQ(read({11, 8, "\x83\x07", 0x20}).bytes[12], 7);
    EXPECT_EQ(read({9, 8, std::string("\x83\0", 2), 0x20, "\1\2\3", 0, 1, 24}).bytes[12], 3);
    expectRefused({10, 32, runs.substr(0, 9), 0x28}, "incomplete");
    expectRefused({10, 32, runs.substr(0, 3), 0x28}, "incomplete");
}

/// An extension area that says what alpha means, and the footer that says where it is.
std::string extensionOf(const Tga& tga, int alphaType) {
    std::string area(495, '\0');
    area[0] = '\xef';
    area[1] = '\x01';
    area.back() = static_cast<char>(alphaType);
    std::string footer(8, '\0');
    footer[0] = static_cast<char>(tga.file().size());
    return area + footer + std::string("TRUEVISION-XFILE.\0", 18);
}

TEST(ReadTgaTest, ExtensionsSayWhatAlphaMeans) {
    Tga tga = {2, 32, std::string("\x0a\x14\x1e\x33", 4) + kFour.substr(4), 0x28};
    const auto firstOf = [&](int alphaType) {
        Tga extended = tga;
        extended.end = extensionOf(tga, alphaType);
        const TexelImage image = read(extended);
        return Bytes(image.bytes.begin(), image.bytes.begin() + 4);
    };
    EXPECT_EQ(firstOf(0), (Bytes{30, 20, 10, 255}));
    EXPECT_EQ(firstOf(2), (Bytes{30, 20, 10, 255}));
    EXPECT_EQ(firstOf(3), (Bytes{30, 20, 10, 51}));
    EXPECT_EQ(firstOf(4), (Bytes{150, 100, 50, 51})); // divided by 51 / 255
}

} // namespace
} // namespace calotype::test
