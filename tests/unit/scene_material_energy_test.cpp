// The albedo that energy warnings go by, of constants and of textures.

#include <cmath>
#include <memory>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "materials/excess_albedo.h"
#include "materials/ggx.h"

namespace calotype {
namespace {

TEST(MaterialEnergyTest, AlbedoOfAMirrorIsFresnelTimesMasking) {
    // k is 1/8 at roughness 0.
    for (const double cosine : {0.05, 0.3, 0.8, 1.0}) {
        const double fresnel = 0.04 + 0.96 * std::pow(1.0 - cosine, 5.0);
        const double g1 = cosine / (cosine * 0.875 + 0.125);
        EXPECT_NEAR(ggxAlbedo(cosine, 0.0, 0.04, Masking::Schlick), fresnel * g1 * g1, 1e-12);
        EXPECT_NEAR(ggxAlbedo(cosine, 0.0, 0.04, Masking::Smith), fresnel, 1e-12);
    }
}

/// The same integral over directions of light on a fine grid, by the equations as they are written
/// (1.27 to 1.30).
double slowAlbedo(double cosine, double roughness, double f0) {
    constexpr int kSteps = 1500;
    const double alpha2 = std::pow(roughness, 4.0);
    const double k = std::pow(roughness + 1.0, 2.0) / 8.0;
    const glm::dvec3 v(std::sqrt(1.0 - cosine * cosine), 0.0, cosine);
    double sum = 0.0;
    for (int i = 0; i < kSteps; ++i) {
        const double z = (i + 0.5) / kSteps;
        for (int j = 0; j < kSteps; ++j) {
            const double azimuth = M_PI * (j + 0.5) / kSteps;
            const double r = std::sqrt(1.0 - z * z);
            const glm::dvec3 l(r * std::cos(azimuth), r * std::sin(azimuth), z);
            const glm::dvec3 h = (v + l) / std::sqrt(2.0 + 2.0 * (v.x * l.x + v.z * l.z));
            const double d = alpha2 / (M_PI * std::pow(h.z * h.z * (alpha2 - 1.0) + 1.0, 2.0));
            const double f = f0 + (1.0 - f0) * std::pow(1.0 - (v.x * h.x + v.z * h.z), 5.0);
            const double g = z / (z * (1.0 - k) + k) * cosine / (cosine * (1.0 - k) + k);
            sum += d * f * g / (4.0 * z * cosine) * z;
        }
    }
    return sum * 2.0 * M_PI / (double(kSteps) * kSteps);
}

TEST(MaterialEnergyTest, AlbedoAgreesWithTheEquationsIntegratedOverTheHemisphere) {
    for (const double roughness : {0.4, 0.7, 1.0}) {
        for (const double cosine : {0.1, 0.4, 0.9}) {
            EXPECT_NEAR(ggxAlbedo(cosine, roughness, 0.04, Masking::Schlick),
                        slowAlbedo(cosine, roughness, 0.04), 0.001)
                << roughness << " " << cosine;
        }
    }
}

/// Textures: a dark and a white texel, as bytes encoded; an encoded grey of 0.9 (linear 0.787); a
/// checker of 0.2 and 0.6.
class ExcessAlbedoTest : public testing::Test {
protected:
    static constexpr uint32_t kBlackAndWhite = 0;
    static constexpr uint32_t kGrey = 1;
    static constexpr uint32_t kChecker = 2;

    ExcessAlbedoTest() {
        addImage({2, 1, {10, 10, 10, 255, 255, 255, 255, 255}, {}, true, false});
        addImage({1, 1, {}, {0.9f, 0.9f, 0.9f, 1.0f}, true, false});
        textures_.push_back({"", CheckerTexture{{glm::dvec3(0.2), glm::dvec3(0.6)}}});
    }

    std::optional<double> of(const Material& material) {
        TextureRanges ranges(textures_);
        return excessAlbedo(material, ranges);
    }

    static Material nonmetal(double color, double roughness) {
        Material material;
        material.type = MaterialType::Nonmetal;
        material.color = glm::dvec3(0.0, color, 0.0);
        material.roughness = roughness;
        return material;
    }

    static Material blinnPhong(double color, double kd, double ks, bool normalize = false) {
        Material material;
        material.type = MaterialType::BlinnPhong;
        material.color = glm::dvec3(0.0, 0.0, color);
        material.kd = kd;
        material.ks = ks;
        material.normalize = normalize;
        return material;
    }

private:
    void addImage(const TexelImage& image) {
        textures_.push_back({"", ImageTexture{std::make_shared<const TexelImage>(image)}});
    }

    std::vector<Texture> textures_;
};

TEST_F(ExcessAlbedoTest, OfConstantNonmetalsIsThatOfTheirIntegral) {
    EXPECT_EQ(of(nonmetal(0.87, 0.0)), std::nullopt);
    // The mirror of the test above, at a cosine of 0.15: 0.466 * 0.585^2 + 0.96 * 0.89.
    EXPECT_NEAR(of(nonmetal(0.89, 0.0)).value(), 1.01406, 1e-5);
    EXPECT_EQ(of(nonmetal(0.95, 0.5)), std::nullopt);
    EXPECT_TRUE(of(nonmetal(1.0, 0.5)));
    // Smith's masking lets more light through.
    Material smooth = nonmetal(0.7, 0.1);
    EXPECT_EQ(of(smooth), std::nullopt);
    smooth.masking = Masking::Smith;
    EXPECT_TRUE(of(smooth));
}

TEST_F(ExcessAlbedoTest, OfNonmetalsTakesTheExtremesOfTheirTextures) {
    Material white = nonmetal(1.0, 0.0);
    white.colorTexture = kBlackAndWhite;
    EXPECT_EQ(of(white), of(nonmetal(1.0, 0.0)));
    white.color = glm::dvec3(0.87); // which multiplies the texture
    EXPECT_EQ(of(white), std::nullopt);
    Material grey = nonmetal(1.0, 0.0);
    grey.colorTexture = kGrey; // too bright only if it were not decoded
    EXPECT_EQ(of(grey), std::nullopt);

    Material rough = nonmetal(0.9, 1.0);
    EXPECT_EQ(of(rough), std::nullopt);
    rough.roughnessTexture = kBlackAndWhite; // from 10 / 255, which is not decoded
    EXPECT_EQ(of(rough), of(nonmetal(0.9, 10.0 / 255.0)));
    rough.roughnessTexture = kChecker;
    EXPECT_EQ(of(rough), std::nullopt);

    Material shiny = nonmetal(0.8, 0.0);
    shiny.masking = Masking::Smith;
    shiny.specular = 0.2;
    const auto wanted = of(shiny);
    EXPECT_TRUE(wanted);
    shiny.specular = 1.0;
    EXPECT_EQ(of(shiny), std::nullopt);
    shiny.specularTexture = kChecker;
    EXPECT_EQ(of(shiny), wanted);
}

TEST_F(ExcessAlbedoTest, OfBlinnPhongIsTheSumOfItsWeights) {
    // 0.7 + 4 * 0.075 is 1 in decimal, and more in binary.
    EXPECT_EQ(of(blinnPhong(0.0, 0.7, 0.075)), std::nullopt);
    EXPECT_NEAR(of(blinnPhong(0.0, 0.7, 0.076)).value(), 1.004, 1e-12);
    EXPECT_EQ(of(blinnPhong(1.0, 0.7, 0.3, true)), std::nullopt);
    EXPECT_NEAR(of(blinnPhong(1.0, 0.7, 0.31, true)).value(), 1.01, 1e-12);
    EXPECT_EQ(of(blinnPhong(0.9, 0.7, 0.31, true)), std::nullopt);
}

TEST_F(ExcessAlbedoTest, OfTexturedBlinnPhongCountsKdTimesTheBrightestTexel) {
    Material paint = blinnPhong(1.0, 0.7, 0.1);
    paint.colorTexture = kBlackAndWhite;
    EXPECT_NEAR(of(paint).value(), 1.1, 1e-12);
    paint.colorTexture = kChecker;
    EXPECT_EQ(of(paint), std::nullopt); // 0.42 + 0.4
    paint.colorTexture = kGrey;
    EXPECT_EQ(of(paint), std::nullopt); // 0.55 + 0.4, since 0.9 decodes to 0.787
}

TEST_F(ExcessAlbedoTest, OfOthersIsNone) {
    for (const auto type : {MaterialType::Diffuse, MaterialType::Metal, MaterialType::Dielectric}) {
        Material material = nonmetal(1.0, 0.0);
        material.type = type;
        EXPECT_EQ(of(material), std::nullopt);
    }
}

} // namespace
} // namespace calotype
