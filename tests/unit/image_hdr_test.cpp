// Radiance pictures to texels: what their headers state is obeyed, or refused with the reason.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "image/read_texel_image.h"
#include "support/image_files.h"
#include "unit/texel_reading.h"

namespace calotype::test {
namespace {

std::string hdrFile(uint32_t width, uint32_t height, const std::string& pixels) {
    return "#?RADIANCE\n# made here\nFORMAT=32-bit_rle_rgbe\n\n-Y " + std::to_string(height) +
           " +X " + std::to_string(width) + "\n" + pixels;
}

TEST(ReadHdrTest, ReadsFlatRowsFromTheTop) {
    // 128 at exponent 129 is 1; exponent 0 is black whatever the mantissas say.
    const TexelImage image =
        read(hdrFile(1, 2, std::string("\x80\x40\x20\x81\x80\x80\x80\x00", 8)));
    EXPECT_EQ(image.floats, (std::vector<float>{1.0f, 0.5f, 0.25f, 1.0f, 0.0f, 0.0f, 0.0f, 1.0f}));
    EXPECT_FALSE(image.isEncoded);
    EXPECT_FALSE(image.isTransparent);
}

TEST(ReadHdrTest, AgreesWithTheWriterOnEncodedRows) {
    constexpr int kWidth = 40;
    constexpr int kHeight = 3;
    std::vector<float> colors;
    for (int i = 0; i < 3 * kWidth * kHeight; ++i)
        colors.push_back(i % 60 < 30 ? 1.5f : std::exp2(static_cast<float>(i % 17) - 8.0f));
    std::string file;
    stbi_write_hdr_to_func(appendTo, &file, kWidth, kHeight, 3, colors.data());
    const TexelImage image = read(file);
    ASSERT_EQ(image.floats.size(), 4u * kWidth * kHeight);
    for (size_t i = 0; i < colors.size(); i += 3) {
        // The mantissas of the three share the largest one's exponent and are rounded down.
        const float unit = std::max({colors[i], colors[i + 1], colors[i + 2]}) / 128.0f;
        for (size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(image.floats[i / 3 * 4 + k], colors[i + k], unit) << i;
    }
    for (size_t length = 0; length < file.size(); ++length)
        EXPECT_THROW(read(file.substr(0, length)), SceneError) << length;
}

TEST(ReadHdrTest, RefusesWhatItCannotRead) {
    expectRefused(hdrFile(2, 2, "short"), "incomplete");
    expectRefused("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\nabcd", "XYZ");
    expectRefused("#?RADIANCE\n\n-Y 1 +Y 1\nabcd", "one axis is stated twice");
    expectRefused("#?RADIANCE\n\n-Z 1 +X 1\nabcd", "size");
    expectRefused("#?RADIANCE\n\n-Y one +X 1\nabcd", "size");
    expectRefused("#?RADIANCE\n\n-Y 1 +X 99999999999\nabcd", "size");
    expectRefused("#?RGBE\n", "incomplete");
    // A run of 0 pixels, which advances nowhere, and one past the end of its row.
    const std::string encodedRow("\x02\x02\x00\x08", 4);
    expectRefused(hdrFile(8, 1, encodedRow + std::string(64, '\0')), "a run of pixels");
    expectRefused(hdrFile(8, 1, encodedRow + std::string(64, '\x89')), "a run of pixels");
}

/// The red values of a picture of two columns and two rows, whose pixels are 1, 2, 4 and 8 in the
/// order of the file.
std::vector<float> redsOf(const std::string& header, const std::string& size) {
    const std::string pixels("\x80\0\0\x81\x80\0\0\x82\x80\0\0\x83\x80\0\0\x84", 16);
    const TexelImage image = read("#?RADIANCE\n" + header + "\n" + size + "\n" + pixels);
    std::vector<float> reds;
    for (size_t i = 0; i < image.floats.size(); i += 4)
        reds.push_back(image.floats[i]);
    return reds;
}

TEST(ReadHdrTest, RowsAndColumnsStartAtAnyCorner) {
    using Reds = std::vector<float>; // top left, top right, bottom left, bottom right
    const std::string header = "FORMAT=32-bit_rle_rgbe\n";
    EXPECT_EQ(redsOf(header, "-Y 2 +X 2"), (Reds{1, 2, 4, 8}));
    EXPECT_EQ(redsOf(header, "-Y 2 -X 2"), (Reds{2, 1, 8, 4}));
    EXPECT_EQ(redsOf(header, "+Y 2 +X 2"), (Reds{4, 8, 1, 2}));
    EXPECT_EQ(redsOf(header, "+Y 2 -X 2"), (Reds{8, 4, 2, 1}));
    EXPECT_EQ(redsOf(header, "+X 2 -Y 2"), (Reds{1, 4, 2, 8}));
    EXPECT_EQ(redsOf(header, "+X 2 +Y 2"), (Reds{2, 8, 1, 4}));
    EXPECT_EQ(redsOf(header, "-X 2 -Y 2"), (Reds{4, 1, 8, 2}));
    EXPECT_EQ(redsOf(header, "-X 2 +Y 2"), (Reds{8, 2, 4, 1}));
    // Sides that differ: one column of four.
    EXPECT_EQ(redsOf(header, "+X 1 -Y 4"), (Reds{1, 2, 4, 8}));
    EXPECT_EQ(redsOf(header, "-Y 1 -X 4"), (Reds{8, 4, 2, 1}));
}

TEST(ReadHdrTest, DividesByEveryExposureAndColourCorrection) {
    using Reds = std::vector<float>;
    EXPECT_EQ(redsOf("EXPOSURE=4.0\n", "-Y 2 +X 2"), (Reds{0.25f, 0.5f, 1, 2}));
    EXPECT_EQ(redsOf("EXPOSURE= 4\nEXPOSURE=+2e0 \n", "-Y 2 +X 2"), (Reds{0.125f, 0.25f, 0.5f, 1}));
    EXPECT_EQ(redsOf("COLORCORR=2 1 1\nEXPOSURE=0.5\n", "-Y 2 +X 2"), (Reds{1, 2, 4, 8}));
    EXPECT_EQ(redsOf("COLORCORR=1 2 2\n", "-Y 2 +X 2"), (Reds{1, 2, 4, 8}));
    for (const char* value : {"0", "-1", "nan", "inf", "2 2", "two", "", "1e999"})
        EXPECT_NE(std::string(errorOf([&] {
                                  redsOf("EXPOSURE=" + std::string(value) + "\n", "-Y 2 +X 2");
                              }).what())
                      .find("EXPOSURE that is not a positive number"),
                  std::string::npos)
            << value;
    expectRefused("#?RADIANCE\nCOLORCORR=1 2\n\n-Y 1 +X 1\nabcd", "three positive numbers");
    expectRefused("#?RADIANCE\nEXPOSURE=1e-30\nEXPOSURE=1e-30\n\n-Y 1 +X 1\n\x80\x80\x80\x80",
                  "beyond the range");
}

TEST(ReadHdrTest, AcceptsOnlyThePrimariesOfRec709) {
    using Reds = std::vector<float>;
    for (const char* same : {"PRIMARIES=0.64 0.33 0.30 0.60 0.15 0.06 0.3127 0.3290\n",
                             "PRIMARIES= .640 .330 .290 .600 .150 .060 .333 .333\n",
                             "PRIMARIES=0 0 0 0 0 0 0 0\nGAMMA=1\n", "SOFTWARE=x\r\n"})
        EXPECT_EQ(redsOf(same, "-Y 2 +X 2"), (Reds{1, 2, 4, 8})) << same;
    expectRefused(
        "#?RADIANCE\nPRIMARIES=.7347 .2653 0 1 .0001 -.077 .3217 .3377\n\n-Y 1 +X 1\nabcd",
        "PRIMARIES");
    expectRefused("#?RADIANCE\nGAMMA=2.2\n\n-Y 1 +X 1\nabcd", "GAMMA");
}

TEST(ReadHdrTest, ReadsOldRunLengths) {
    // A pixel, itself twice more, another and itself 256 + 3 times more.
    const std::string row("\x80\0\0\x81\1\1\1\2\x80\0\0\x82\1\1\1\3\1\1\1\1", 20);
    const TexelImage image =
        readTexelImage("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 263\n" + row, 300, "image");
    for (size_t x = 0; x < 263; ++x)
        EXPECT_EQ(image.floats[4 * x], x < 3 ? 1.0f : 2.0f) << x;
    expectRefused(hdrFile(4, 1, std::string("\1\1\1\3\x80\0\0\x81", 8)), "a run of pixels");
    expectRefused(hdrFile(4, 1, std::string("\x80\0\0\x81\1\1\1\4", 8)), "a run of pixels");
    expectRefused(hdrFile(8, 1, std::string("\2\2\0\x07", 4) + std::string(64, '\x01')),
                  "another length");
}

TEST(ReadHdrTest, LimitsSides) {
    expectRefused(hdrFile(65, 1, ""), "64; scale it down");
    expectRefused(hdrFile(1, 65, ""), "64; scale it down");
    expectRefused(hdrFile(0, 1, ""), "no pixels");
    expectRefused(hdrFile(1, 0, ""), "no pixels");
}

} // namespace
} // namespace calotype::test
