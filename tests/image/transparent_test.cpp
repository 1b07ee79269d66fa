// A background that is hidden from the camera: alpha in scenes whose answers are known, what stays
// as it is, and the reference tracer.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "film/block_count.h"
#include "image/judged_scenes.h"
#include "reference/reference_tracer.h"
#include "render/reference_block.h"
#include "support/agreement.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

RenderWish transparent(RenderWish wish = {}) {
    wish.transport.hidesBackground = true;
    return wish;
}

double meanOf(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

class TransparentTest : public GpuTest {};

// Each sample of the whole picture shows the scene or the background. So the picture laid over the
// background, by its own alpha, is the whole picture: at edges, through every filter and lens, with
// cut-outs, mirrors and glass.
TEST_F(TransparentTest, LaidOverTheBackgroundItIsTheWholePicture) {
    size_t atEdges = 0; // pixels
    for (const char* path :
         {"scenes/background.json", "scenes/orthographic.json", "scenes/depth-of-field.json",
          "scenes/dielectric.json", "tests/image/scenes/everything.json"}) {
        SCOPED_TRACE(path);
        Scene scene = projectScene(path);
        scene.background = {0.25, 0.5, 1.5};
        RenderWish wish;
        wish.width = wish.height = 48;
        wish.samplesPerPixel = 16;
        const RenderedScene whole = renderScene(scene, wish);
        const RenderedScene part = renderScene(scene, transparent(wish));
        const std::vector<float> alpha = part.film.alpha();
        ASSERT_EQ(alpha.size(), whole.image.pixels.size());
        EXPECT_TRUE(whole.film.alpha().empty());
        const glm::vec3 background(scene.background);
        for (size_t i = 0; i < alpha.size(); ++i) {
            const glm::vec3 over = part.image.pixels[i] + (1.0f - alpha[i]) * background;
            const float size = 1.0f + glm::length(over);
            EXPECT_LT(glm::distance(over, whole.image.pixels[i]), 1e-5f * size) << "pixel " << i;
            if (alpha[i] == 0.0f)
                EXPECT_EQ(part.image.pixels[i], glm::vec3(0.0f));
        }
        for (const float share : alpha)
            atEdges += share > 0.0f && share < 1.0f ? 1 : 0;
    }
    EXPECT_GT(atEdges, 250u);
}

/// A ball of radius 1 of this material under a background of 1, seen from afar: 4 x 4 metres.
Scene ballScene(const Material& material) {
    SceneBuilder builder;
    builder.add(makeShape(Sphere{{}, 1.0}, builder.material(material))).lookAtPlaneZ(4.0);
    builder.scene().background = glm::dvec3(1.0);
    builder.scene().film = {32, 32};
    return builder.scene();
}

// The mean alpha is the share of the picture that the disk of the ball takes. Glass and mirrors
// hide nothing, since what they show is light of the scene; in the furnace they are 1.
TEST_F(TransparentTest, AlphaIsTheShareThatAShapeCovers) {
    Material white;
    white.color = glm::dvec3(1.0);
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    Material mirror;
    mirror.type = MaterialType::Metal;
    mirror.color = glm::dvec3(1.0);
    mirror.roughness = 0.0;
    mirror.masking = Masking::Smith;
    for (const Material& material : {white, glass, mirror}) {
        Scene scene = ballScene(material);
        RenderWish wish = transparent();
        wish.samplesPerPixel = 64;
        wish.maxBounces = 64;
        wish.sampler = Sampler::Sobol;
        wish.transport.usesRoulette = false;
        const RenderedScene rendered = renderScene(scene, wish);
        const std::vector<float> alpha = rendered.film.alpha();
        // 60 pixels on the edge, each off by 1/16 at most.
        EXPECT_NEAR(meanOf(alpha), std::numbers::pi / 16.0, 2.0 * std::sqrt(60.0) / 16.0 / 1024.0);
        if (material.type == MaterialType::Diffuse)
            continue; // whose samples are noisy even here
        for (size_t i = 0; i < alpha.size(); ++i)
            EXPECT_NEAR(rendered.image.pixels[i].g, alpha[i], 2e-3f) << "pixel " << i;
    }
}

// A cut-out of opacity 1/4 covers a quarter; a lamp in view covers its pixels, and one that is
// hidden from the camera does not.
TEST_F(TransparentTest, CutOutsAndLampsInView) {
    const auto alphaOf = [](const Material& material) {
        SceneBuilder builder;
        builder
            .rectangle({-9.0, -9.0, 0.0}, {18.0, 0.0, 0.0}, {0.0, 18.0, 0.0},
                       builder.material(material))
            .lookAtPlaneZ(4.0);
        builder.scene().background = glm::dvec3(2.0);
        RenderWish wish = transparent();
        wish.samplesPerPixel = 64;
        const RenderedScene rendered = renderScene(builder.scene(), wish);
        return std::pair(meanOf(rendered.film.alpha()), rendered.image.at(3, 3));
    };
    Material leaf;
    leaf.color = glm::dvec3(0.0);
    leaf.opacity = 0.25;
    EXPECT_NEAR(alphaOf(leaf).first, 0.25, 5.0 * std::sqrt(0.1875 / (16 * 16 * 64)));
    Material lamp;
    lamp.color = glm::dvec3(0.0);
    lamp.emission = {3.0, 2.0, 1.0};
    EXPECT_EQ(alphaOf(lamp), (std::pair(1.0, glm::vec3(3.0f, 2.0f, 1.0f))));
    lamp.visibleToCamera = false;
    EXPECT_EQ(alphaOf(lamp), (std::pair(0.0, glm::vec3(0.0f))));
}

// Whatever the camera sees of the scene itself stays bit for bit as it is.
TEST_F(TransparentTest, KeepsWhatIsCovered) {
    const Scene scene = projectScene("scenes/cornell-box.json");
    RenderWish wish;
    wish.width = wish.height = 32;
    wish.samplesPerPixel = 16;
    const RenderedScene whole = renderScene(scene, wish);
    const RenderedScene part = renderScene(scene, transparent(wish));
    const std::vector<float> alpha = part.film.alpha();
    for (size_t i = 0; i < alpha.size(); ++i)
        EXPECT_EQ(part.image.pixels[i], whole.image.pixels[i]);
    EXPECT_GT(meanOf(alpha), 0.5);
}

class TransparentAgreementTest : public GpuTest, public testing::WithParamInterface<JudgedScene> {};

// The first samples of device and reference, from the same random numbers.
TEST_P(TransparentAgreementTest, SamplesShowNothingInTheSamePixels) {
    constexpr uint32_t kSide = 64;
    const Scene scene = projectScene(GetParam().path);
    RenderSettings settings = squareSettings(scene, kSide, 3);
    settings.maxBounces = 0; // of which alpha does not depend
    settings.transport.hidesBackground = true;
    DeviceTracer device(scene, settings);
    const reference::ReferenceTracer tracer(scene, {kSide, kSide}, 0, settings.transport);
    ReferenceBlock reference(tracer, settings, 2);
    const auto hiddenOf = [](BlockTracer& block) {
        block.beginBlock(0);
        while (block.renderTiles({0, block.tileCount()}, 4).unfinishedPixels > 0) {
        }
        std::vector<uint32_t> hidden;
        for (const glm::vec4& sum : block.readBlock()) {
            EXPECT_EQ(blockCountOf(sum.w).samples, 4u);
            hidden.push_back(blockCountOf(sum.w).hidden);
        }
        return hidden;
    };
    const std::vector<uint32_t> found = hiddenOf(device.tracer());
    const std::vector<uint32_t> expected = hiddenOf(reference);
    size_t differing = 0;
    for (size_t i = 0; i < found.size(); ++i)
        differing += found[i] != expected[i] ? 1 : 0;
    // At edges, where rounding decides: one pixel in a thousand, and one.
    EXPECT_LE(differing, found.size() / 1000 + 1);
}

INSTANTIATE_TEST_SUITE_P(Scenes, TransparentAgreementTest,
                         testing::Values(kJudgedScenes[1], kJudgedScenes[6], kJudgedScenes[9],
                                         kJudgedScenes[11]),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace calotype::test
