// Which texels the kernels read: the very one at its centre, as it is or decoded, and never one
// beyond the image.
#include <memory>

#include "support/gpu_test.h"
#include "support/packed_textures.h"

namespace calotype::test {
namespace {

class TextureTexelTest : public GpuTest {};

// Sizes whose texel centres float holds: no weight of a neighbour comes in.
TEST_F(TextureTexelTest, IsTheTexelItselfAtItsCentre) {
    RandomNumbers random(105);
    const PackedTextures packed(variedTextures({{1, 1, true, false},
                                                {16, 16, true, false},
                                                {16, 16, false, false},
                                                {16384, 1, true, true}},
                                               random));
    for (uint32_t index = 0; index < packed.textures().size(); ++index) {
        const Texture& texture = packed.textures()[index];
        const TexelImage& image = imageOf(texture);
        std::vector<shared::TestTextureRead> reads;
        for (uint32_t row = 0; row < image.height; ++row)
            for (uint32_t column = 0; column < image.width; ++column)
                reads.push_back(
                    {{(column + 0.5) / image.width, 1.0 - (row + 0.5) / image.height}, index, 0});
        const auto colors = packed.read(reads);
        for (size_t texel = 0; texel < reads.size(); ++texel)
            for (int channel = 0; channel < 4; ++channel) {
                const size_t i = 4 * texel + channel;
                if (image.holdsBytes())
                    ASSERT_NEAR(colors[texel][channel], image.bytes[i] / 255.0, kRoundoffOfFloat);
                else
                    ASSERT_EQ(colors[texel][channel], image.floats[i]);
            }
    }
}

TEST_F(TextureTexelTest, DecodesNeitherAlphaNorWhatIsNoColor) {
    TexelImage image;
    image.width = image.height = 1;
    image.isEncoded = true;
    image.bytes = {128, 64, 255, 128};
    Texture color = imageTexture(std::make_shared<const TexelImage>(image), TextureWrap::Repeat,
                                 TextureFilter::Bilinear);
    Texture linear = color;
    std::get<ImageTexture>(linear.source).decodesColor = false;
    const auto colors =
        PackedTextures({color, linear}).read({{{}, 0, 1}, {{}, 0, 0}, {{}, 1, 1}, {{}, 1, 0}});
    EXPECT_NEAR(colors[0].r, 0.2158605, 1e-6);
    EXPECT_NEAR(colors[0].g, 0.0512695, 1e-6);
    for (size_t i = 0; i < colors.size(); ++i) {
        EXPECT_FLOAT_EQ(colors[i].a, 128.0f / 255.0f);
        EXPECT_NEAR(colors[i].b, 1.0f, i == 0 ? kDecodingError : 0.0);
        if (i > 0)
            EXPECT_FLOAT_EQ(colors[i].r, 128.0f / 255.0f);
    }
}

TEST_F(TextureTexelTest, KeepsEachImageOnce) {
    RandomNumbers random(107);
    const PackedTextures packed(variedTextures({{5, 3, true, true}, {1, 7, false, false}}, random));
    EXPECT_EQ(packed.textures().size(), 12u);
    EXPECT_EQ(packed.rowCount(), 4u + 7u); // 15 texels at four a row, 7 at one a row
}

// What a file may say: coordinates beyond all reason are some texel, or not a number; never a read
// outside the image.
TEST_F(TextureTexelTest, SurvivesCoordinatesWithoutBound) {
    RandomNumbers random(108);
    const PackedTextures packed(
        variedTextures({{5, 3, true, true}, {16, 16, false, false}}, random));
    std::vector<shared::TestTextureRead> reads;
    for (uint32_t i = 0; i < packed.textures().size(); ++i)
        for (const float u : {-3e38f, -1e30f, -1e10f, 1e10f, 1e30f, 3e38f})
            reads.push_back({{u, 0.5f}, i, 0});
    for (const glm::vec4& color : packed.read(reads))
        for (int channel = 0; channel < 4; ++channel) {
            EXPECT_GE(color[channel], 0.0f);
            EXPECT_LE(color[channel], 20.0f);
        }
}

} // namespace
} // namespace calotype::test
