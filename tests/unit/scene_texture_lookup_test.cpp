// Scalars from textures, against a slow reference that finds texels by walking.

#include <cmath>
#include <memory>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "scene/material_textures.h"
#include "scene/texture_lookup.h"

namespace calotype {
namespace {

/// Every product and sum of the lookups is rounded a few times, at coordinates below 100.
constexpr double kRounding = 1e-12;

TexelImage randomBytes(uint32_t width, uint32_t height) {
    std::mt19937 random(width * 100 + height);
    TexelImage image{width, height, std::vector<uint8_t>(4 * width * height), {}, true, false};
    for (uint8_t& byte : image.bytes)
        byte = static_cast<uint8_t>(random() & 255);
    return image;
}

Texture textureOf(TexelImage image, TextureWrap wrap, TextureFilter filter) {
    Texture texture;
    texture.source =
        ImageTexture{std::make_shared<const TexelImage>(std::move(image)), wrap, filter, true};
    return texture;
}

/// Walks from the edge of the image, one texel at a time, to the texel `index`.
int walk(int index, int count, TextureWrap wrap) {
    int at = 0;
    int step = 1;
    for (int i = 0; i != index; i += index > 0 ? 1 : -1) {
        const int direction = index > 0 ? step : -step;
        const int next = at + direction;
        const bool outside = next < 0 || next >= count;
        if (!outside)
            at = next;
        else if (wrap == TextureWrap::Repeat)
            at = next < 0 ? count - 1 : 0;
        else if (wrap == TextureWrap::Mirror)
            step = -step; // the edge texel is seen twice
    }
    return at;
}

double texel(const TexelImage& image, int column, int rowFromBottom, TextureWrap wrap) {
    const int x = walk(column, static_cast<int>(image.width), wrap);
    const int y = walk(rowFromBottom, static_cast<int>(image.height), wrap);
    const int row = static_cast<int>(image.height) - 1 - y;
    return image.bytes[4 * (row * static_cast<int>(image.width) + x)] / 255.0;
}

/// The texture is the sum of tents around the texel centres, or of boxes.
double reference(const TexelImage& image, double u, double v, TextureWrap wrap,
                 TextureFilter filter) {
    const double x = u * image.width;
    const double y = v * image.height;
    double sum = 0.0;
    for (int column = static_cast<int>(x) - 3; column <= static_cast<int>(x) + 3; ++column) {
        for (int row = static_cast<int>(y) - 3; row <= static_cast<int>(y) + 3; ++row) {
            double weight = 0.0;
            if (filter == TextureFilter::Bilinear) {
                weight = std::max(0.0, 1.0 - std::abs(column + 0.5 - x)) *
                         std::max(0.0, 1.0 - std::abs(row + 0.5 - y));
            } else {
                weight = column <= x && x < column + 1 && row <= y && y < row + 1 ? 1.0 : 0.0;
            }
            sum += weight * texel(image, column, row, wrap);
        }
    }
    return sum;
}

TEST(TextureLookupTest, AgreesWithTheReferenceInsideAtEdgesAndFarOutside) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> inside(0.0, 1.0);
    std::uniform_real_distribution<double> outside(-9.0, 9.0);
    for (const auto& [width, height] : {std::pair{1u, 1u}, {5u, 3u}, {2u, 1u}, {4u, 8u}}) {
        const TexelImage image = randomBytes(width, height);
        std::vector<glm::dvec2> points = {{0, 0}, {1, 1}, {0, 1}, {-1, 2}, {1, 0.5}, {-3, -3}};
        for (int i = 0; i < 200; ++i) {
            points.emplace_back(inside(random), inside(random));
            points.emplace_back(outside(random), outside(random));
        }
        for (const auto wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror}) {
            for (const auto filter : {TextureFilter::Bilinear, TextureFilter::Nearest}) {
                const Texture texture = textureOf(image, wrap, filter);
                for (const glm::dvec2& p : points) {
                    ASSERT_NEAR(lookUpScalar(texture, p), reference(image, p.x, p.y, wrap, filter),
                                kRounding)
                        << width << " x " << height << " at " << p.x << ", " << p.y << " wrap "
                        << int(wrap) << " filter " << int(filter);
                }
            }
        }
    }
}

TEST(TextureLookupTest, TexelCentresGiveTexelsTheRightWayUp) {
    const TexelImage image = randomBytes(5, 3);
    for (const auto filter : {TextureFilter::Bilinear, TextureFilter::Nearest}) {
        const Texture texture = textureOf(image, TextureWrap::Repeat, filter);
        for (uint32_t row = 0; row < 3; ++row) {
            for (uint32_t column = 0; column < 5; ++column) {
                // Row 0 is the top of the image, which lies at v = 1.
                const glm::dvec2 centre((column + 0.5) / 5.0, 1.0 - (row + 0.5) / 3.0);
                EXPECT_NEAR(lookUpScalar(texture, centre),
                            image.bytes[4 * (row * 5 + column)] / 255.0, kRounding);
            }
        }
    }
}

TEST(TextureLookupTest, ScalesAndShiftsBeforeItWraps) {
    const TexelImage image = randomBytes(4, 4);
    const Texture plain = textureOf(image, TextureWrap::Repeat, TextureFilter::Bilinear);
    Texture moved = plain;
    moved.scale = {2.0, -3.0};
    moved.offset = {0.25, 0.5};
    for (const glm::dvec2 uv : {glm::dvec2(0.1, 0.2), {0.9, -0.7}, {3.3, 4.4}}) {
        EXPECT_EQ(lookUpScalar(moved, uv),
                  lookUpScalar(plain, {2.0 * uv.x + 0.25, -3.0 * uv.y + 0.5}));
    }
}

TEST(TextureLookupTest, FloatsAreReadAsTheyAre) {
    const TexelImage image{2, 1, {}, {-3.5f, 9, 9, 1, 1000.0f, 9, 9, 1}, false, false};
    const Texture texture = textureOf(image, TextureWrap::Clamp, TextureFilter::Bilinear);
    EXPECT_EQ(lookUpScalar(texture, {0.25, 0.5}), -3.5);
    EXPECT_EQ(lookUpScalar(texture, {0.75, 0.5}), 1000.0);
    EXPECT_EQ(lookUpScalar(texture, {0.5, 0.5}), 0.5 * (1000.0 - 3.5));
    EXPECT_EQ(lookUpScalar(texture, {-5.0, 0.5}), -3.5);
}

/// A white leaf beside transparent texels of any colour.
TexelImage leaf(uint8_t alphaBeside) {
    return {2, 1, {255, 255, 255, 255, 9, 99, 200, alphaBeside}, {}, true, true};
}

TEST(TextureLookupTest, ColoursOfCutOutsAreThoseOfTheirOpaqueTexels) {
    const Texture texture = textureOf(leaf(0), TextureWrap::Clamp, TextureFilter::Bilinear);
    for (const double u : {0.0, 0.25, 0.26, 0.5, 0.7499})
        EXPECT_EQ(lookUpCutOutColor(texture, {u, 0.5}), glm::dvec3(1.0)) << u;
    // Alpha itself is filtered plainly.
    EXPECT_NEAR(lookUp(texture, {0.5, 0.5}, true).w, 0.5, kRounding);
    // Only transparent texels: their colour is as good as any, and finite.
    EXPECT_NEAR(lookUpCutOutColor(texture, {0.75, 0.5}).y, lookUp(texture, {0.75, 0.5}, true).y,
                kRounding);
}

TEST(TextureLookupTest, ColoursOfCutOutsAreWeightedByAlpha) {
    // Alphas of 1 and 1/5 with weights of 1/4 and 3/4: shares of 5/8 and 3/8.
    const Texture texture = textureOf(leaf(51), TextureWrap::Clamp, TextureFilter::Bilinear);
    const glm::dvec3 beside(lookUp(texture, {0.75, 0.5}, true));
    const glm::dvec3 color = lookUpCutOutColor(texture, {0.625, 0.5});
    for (int i = 0; i < 3; ++i)
        EXPECT_NEAR(color[i], 0.625 + 0.375 * beside[i], kRounding) << i;
}

TEST(TextureLookupTest, OnlyMaterialsWithHolesHaveColoursOfCutOuts) {
    const std::vector<Texture> textures = {
        textureOf(leaf(0), TextureWrap::Clamp, TextureFilter::Bilinear),
        textureOf(randomBytes(2, 2), TextureWrap::Clamp, TextureFilter::Bilinear)};
    Material material;
    EXPECT_FALSE(hasCutOutColors(material, textures));
    material.colorTexture = 0;
    EXPECT_FALSE(hasCutOutColors(material, textures)); // "alpha": false
    material.alphaTexture = 0;
    EXPECT_TRUE(hasCutOutColors(material, textures));
    material.alphaTexture = 1; // map_d
    EXPECT_TRUE(hasCutOutColors(material, textures));
    material.colorTexture = 1; // an opaque image
    EXPECT_FALSE(hasCutOutColors(material, textures));
}

TEST(TextureLookupTest, CheckersTurnWithTheParityOfTheirFields) {
    Texture checker;
    checker.source = CheckerTexture{{glm::dvec3(0.25, 9, 9), glm::dvec3(0.75, 9, 9)}};
    checker.scale = {8.0, 4.0};
    for (int x = -9; x < 9; ++x) {
        for (int y = -9; y < 9; ++y) {
            const bool even = (x + y + 100) % 2 == 0;
            EXPECT_EQ(lookUpScalar(checker, {(x + 0.5) / 8.0, (y + 0.5) / 4.0}), even ? 0.25 : 0.75)
                << x << " " << y;
        }
    }
}

TEST(TextureLookupTest, StaysInRangeAtAnyCoordinate) {
    const TexelImage image = randomBytes(5, 3);
    Texture checker;
    checker.source = CheckerTexture{{glm::dvec3(0.0), glm::dvec3(1.0)}};
    for (const auto wrap : {TextureWrap::Repeat, TextureWrap::Clamp, TextureWrap::Mirror}) {
        for (const auto filter : {TextureFilter::Bilinear, TextureFilter::Nearest}) {
            Texture texture = textureOf(image, wrap, filter);
            for (const double u : {1e9, -1e9, 1e18, -1e18, 1e299, 1e308, -1e308}) {
                for (const double scale : {1.0, 1e10}) {
                    texture.scale = checker.scale = {scale, -scale};
                    for (const Texture& t : {texture, checker}) {
                        const double value = lookUpScalar(t, {u, u});
                        EXPECT_TRUE(value >= 0.0 && value <= 1.0) << value << " at " << u;
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace calotype
