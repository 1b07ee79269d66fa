// What a pixel shows through its filter, in mirrors and through glass: in scenes whose answers are
// known, and against the reference tracer.
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "engine/compile_scene.h"
#include "image/judged_scenes.h"
#include "render/feature_pass.h"
#include "render/reference_features.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

RenderSettings settingsOf(uint32_t width, uint32_t height) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.crop = {0, 0, width, height};
    settings.bvh = BvhBuilder::Sah;
    return settings;
}

FeatureImage featuresOf(const Scene& scene, const RenderSettings& settings, uint32_t rays) {
    const GpuScene packed = compileScene(scene, settings).packed;
    const SceneBuffers buffers(testDevice(), packed);
    return FeaturePass(testDevice(), packed, buffers, packed.features, settings).run(rays);
}

FeatureImage featuresOf(const Scene& scene, uint32_t rays) {
    return featuresOf(scene, settingsOf(scene.film.width, scene.film.height), rays);
}

void expectNear(const glm::vec3& v, const glm::vec3& wanted, float tolerance = 1e-5f) {
    EXPECT_LT(glm::distance(v, wanted), tolerance) << v.x << ", " << v.y << ", " << v.z;
}

class FeaturePassTest : public GpuTest {};

TEST_F(FeaturePassTest, OfNothingIsNothing) {
    SceneBuilder builder;
    for (const Features& pixel : featuresOf(builder.scene(), 2).pixels) {
        expectNear(pixel.meanAlbedo, glm::vec3(0.0f));
        expectNear(pixel.meanNormal, glm::vec3(0.0f));
        EXPECT_EQ(pixel.meanDepth, std::numeric_limits<float>::infinity());
        EXPECT_EQ(pixel.alpha, 0.0f);
    }
}

// Rays that a limit ends behind many clear squares are counted.
TEST_F(FeaturePassTest, DeepStacksAreCutAndCounted) {
    const auto cutRaysBehind = [&](uint32_t squares) {
        SceneBuilder builder;
        Material clear;
        clear.opacity = 0.0;
        const uint32_t clearIndex = builder.material(clear);
        for (uint32_t i = 1; i <= squares; ++i)
            builder.rectangle({-9.0, -9.0, 4.0 * i / squares}, {18.0, 0.0, 0.0}, {0.0, 18.0, 0.0},
                              clearIndex);
        builder.lookAtPlaneZ(9.0);
        builder.scene().film = {2, 2};
        const RenderSettings settings = settingsOf(2, 2);
        const GpuScene packed = compileScene(builder.scene(), settings).packed;
        const SceneBuffers buffers(testDevice(), packed);
        FeaturePass pass(testDevice(), packed, buffers, packed.features, settings);
        pass.run(3);
        return pass.cutRays();
    };
    EXPECT_EQ(cutRaysBehind(60), 0u);
    EXPECT_EQ(cutRaysBehind(1100), 12u) << "three rays in each of four pixels";
}

// A light has the albedo that it shows on a display.
TEST_F(FeaturePassTest, OfTheBackgroundIsItsColorOnADisplay) {
    SceneBuilder builder;
    builder.scene().background = {0.25, 3.0, 0.0};
    for (const Features& pixel : featuresOf(builder.scene(), 2).pixels) {
        expectNear(pixel.meanAlbedo, glm::vec3(0.25f, 1.0f, 0.0f));
        EXPECT_EQ(pixel.alpha, 0.0f);
    }
}

// Where it is hidden from the camera it has no albedo, but is seen in a mirror.
TEST_F(FeaturePassTest, OfAHiddenBackgroundIsNothing) {
    for (const bool hasMirror : {false, true}) {
        SceneBuilder builder;
        builder.scene().background = glm::dvec3(0.5);
        Material mirror;
        mirror.type = MaterialType::Metal;
        mirror.color = glm::dvec3(1.0);
        mirror.roughness = 0.0;
        mirror.masking = Masking::Smith;
        if (hasMirror)
            builder
                .rectangle({-9.0, -9.0, 0.0}, {18.0, 0.0, 0.0}, {0.0, 18.0, 0.0},
                           builder.material(mirror))
                .lookAtPlaneZ(4.0);
        RenderSettings settings = settingsOf(4, 4);
        settings.transport.hidesBackground = true;
        const glm::vec3 expected(hasMirror ? 0.5f : 0.0f);
        for (const Features& pixel : featuresOf(builder.scene(), settings, 2).pixels)
            expectNear(pixel.meanAlbedo, expected);
        const reference::ReferenceTracer tracer(builder.scene(), {4, 4}, 0, settings.transport);
        for (const Features& pixel : referenceFeatures(tracer, settings, 2, 1).pixels)
            expectNear(pixel.meanAlbedo, expected);
    }
}

// The share of each pixel that an edge leaves is the mean of its rays: here 0, 1/4 or 1.
TEST_F(FeaturePassTest, OfAnEdgeIsTheShareOfThePixel) {
    SceneBuilder builder;
    Material red;
    red.color = {0.8, 0.1, 0.0};
    builder.rectangle({-3.0, -3.0, 0.0}, {3.25, 0.0, 0.0}, {0.0, 6.0, 0.0}, builder.material(red))
        .lookAtPlaneZ(4.0);
    builder.scene().film = {4, 4};
    constexpr uint32_t kRays = 256;
    const FeatureImage image = featuresOf(builder.scene(), kRays);
    for (uint32_t y = 0; y < 4; ++y)
        for (uint32_t x = 0; x < 4; ++x) {
            const Features& pixel = image.at(x, y);
            const float share = x < 2 ? 1.0f : x == 2 ? 0.25f : 0.0f;
            // Sobol's points miss a share by a few of their number at most.
            EXPECT_NEAR(pixel.alpha, share, 3.0f / kRays);
            expectNear(pixel.meanAlbedo, pixel.alpha * glm::vec3(0.8f, 0.1f, 0.0f));
            expectNear(pixel.meanNormal, pixel.alpha * glm::vec3(0, 0, 1));
            if (share > 0.0f)
                EXPECT_NEAR(pixel.meanDepth, 5.0f, 1e-5f);
        }
}

// The mirror's colour times the wall's; the normal of the wall, the depth of the mirror.
TEST_F(FeaturePassTest, OfAMirrorIsWhatItShows) {
    SceneBuilder builder;
    Material mirror;
    mirror.type = MaterialType::Metal;
    mirror.color = {1.0, 0.5, 0.25};
    mirror.roughness = 0.0;
    mirror.masking = Masking::Smith; // exact for a mirror
    Material wall;
    wall.color = {0.5, 0.5, 0.8};
    // At 45 degrees: rays along -z leave along -x.
    builder.rectangle({-4.0, -4.0, -4.0}, {8.0, 0.0, 8.0}, {0.0, 8.0, 0.0},
                      builder.material(mirror));
    builder.rectangle({-9.0, -9.0, -9.0}, {0.0, 0.0, 18.0}, {0.0, 18.0, 0.0},
                      builder.material(wall));
    builder.lookAtPlaneZ(1.0);
    for (const Features& pixel : featuresOf(builder.scene(), 4).pixels) {
        // Schlick's Fresnel term at 45 degrees.
        const double fresnel = std::pow(1.0 - std::sqrt(0.5), 5.0);
        const glm::dvec3 reflected = mirror.color + (1.0 - mirror.color) * fresnel;
        expectNear(pixel.meanAlbedo, glm::vec3(reflected * wall.color), 1e-4f);
        expectNear(pixel.meanNormal, glm::vec3(1, 0, 0));
        EXPECT_NEAR(pixel.meanDepth, 5.0f, 0.6f);
        EXPECT_EQ(pixel.alpha, 1.0f);
    }
}

// Through a clear plate: what is behind it, but for the share that is reflected into the dark.
TEST_F(FeaturePassTest, OfGlassIsWhatIsBehindIt) {
    SceneBuilder builder;
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    glass.ior = 1.5;
    Material wall;
    wall.color = {0.9, 0.6, 0.3};
    const uint32_t clear = builder.material(glass);
    builder.rectangle({-4.0, -4.0, 1.0}, {8.0, 0.0, 0.0}, {0.0, 8.0, 0.0}, clear);
    builder.rectangle({-4.0, 4.0, 0.0}, {8.0, 0.0, 0.0}, {0.0, -8.0, 0.0}, clear);
    builder.rectangle({-4.0, -4.0, -1.0}, {8.0, 0.0, 0.0}, {0.0, 8.0, 0.0}, builder.material(wall));
    builder.lookAtPlaneZ(1.0);
    builder.scene().film = {4, 4};
    constexpr uint32_t kRays = 1024;
    // Two faces reflect r each; with all orders 1 - 2 r / (1 + r) passes. The wall ends every path.
    const float r = 0.04f;
    const float passes = 1.0f - 2.0f * r / (1.0f + r);
    for (const Features& pixel : featuresOf(builder.scene(), kRays).pixels) {
        expectNear(pixel.meanAlbedo, passes * glm::vec3(0.9f, 0.6f, 0.3f), 0.02f);
        EXPECT_NEAR(pixel.meanDepth, 4.0f, 1e-5f);
    }
}

class FeatureAgreementTest : public GpuTest, public testing::WithParamInterface<JudgedScene> {};

// With the same random numbers, so that rays go the same ways but for rounding.
TEST_P(FeatureAgreementTest, EqualButForSomePixels) {
    constexpr uint32_t kSide = 64;
    constexpr uint32_t kRays = 4;
    const Scene scene = projectScene(GetParam().path);
    const RenderSettings settings = settingsOf(kSide, kSide);
    const reference::ReferenceTracer tracer(scene, {kSide, kSide}, 0);
    const FeatureImage expected = referenceFeatures(tracer, settings, kRays, 2);
    const FeatureImage image = featuresOf(scene, settings, kRays);
    size_t differing = 0;
    for (size_t i = 0; i < image.pixels.size(); ++i) {
        const Features& a = image.pixels[i];
        const Features& b = expected.pixels[i];
        const bool isNear = glm::distance(a.meanAlbedo, b.meanAlbedo) < 1e-3f &&
                            glm::distance(a.meanNormal, b.meanNormal) < 1e-3f &&
                            a.alpha == b.alpha &&
                            (a.meanDepth == b.meanDepth ||
                             std::abs(a.meanDepth - b.meanDepth) < 1e-4f * b.meanDepth);
        differing += isNear ? 0 : 1;
    }
    const double most = GetParam().mostDiffering * kRays * kSide * kSide + 1.0;
    EXPECT_LE(static_cast<double>(differing), most);
}

INSTANTIATE_TEST_SUITE_P(Scenes, FeatureAgreementTest, testing::ValuesIn(kJudgedScenes),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace calotype::test
