// Which primitives the rays of features show: in scenes whose answers are known, and against the
// reference tracer.
#include <cmath>

#include "engine/compile_scene.h"
#include "image/coverage.h"
#include "image/judged_scenes.h"
#include "render/feature_pass.h"
#include "render/reference_features.h"
#include "scene/matte_names.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

RenderSettings coverageSettings(uint32_t width, uint32_t height) {
    RenderSettings settings;
    settings.width = width;
    settings.height = height;
    settings.crop = {0, 0, width, height};
    settings.bvh = BvhBuilder::Sah;
    return settings;
}

Coverage coverageOf(const Scene& scene, const RenderSettings& settings, uint32_t rays) {
    const GpuScene packed = compileScene(scene, settings).packed;
    const SceneBuffers buffers(testDevice(), packed);
    const MatteNames names = objectNames(scene);
    Coverage coverage(size_t{settings.width} * settings.height);
    FeaturePass(testDevice(), packed, buffers, packed.features, settings)
        .run(rays, {}, [&](auto ray) { coverage.addRay(ray, names.ofPrimitives); });
    return coverage;
}

class CoverageTest : public GpuTest {};

// A pixel of 1 x 1 metres shows a wall of glass on its left, which hides what is behind it, then a
// cut-out of opacity 1/2 before a floor, and nothing in its last eighth.
TEST_F(CoverageTest, IsTheShareOfThePixel) {
    SceneBuilder builder;
    Material glass;
    glass.type = MaterialType::Dielectric;
    glass.color = glm::dvec3(1.0);
    Material leaf;
    leaf.color = glm::dvec3(1.0);
    leaf.opacity = 0.5;
    const glm::dvec3 up(0.0, 4.0, 0.0);
    builder.rectangle({-2.0, -2.0, 1.0}, {1.75, 0.0, 0.0}, up, builder.material(glass))
        .rectangle({-2.0, -2.0, 0.0}, {2.375, 0.0, 0.0}, up, builder.material(leaf))
        .rectangle({-2.0, -2.0, -1.0}, {2.375, 0.0, 0.0}, up, builder.material(0.5, 0.0))
        .lookAtPlaneZ(1.0);
    builder.scene().film = {1, 1};
    constexpr uint32_t kRays = 1024;
    const auto shares = coverageOf(builder.scene(), coverageSettings(1, 1), kRays).ranked(0);
    ASSERT_EQ(shares.size(), 3u);
    std::vector<double> found(3);
    for (const auto& [thing, share] : shares)
        found[thing] = share;
    EXPECT_NEAR(found[0], 0.25, 3.0 / kRays); // Sobol's points miss a share by a few
    EXPECT_NEAR(found[0] + found[1] + found[2], 0.875, 3.0 / kRays);
    EXPECT_NEAR(found[1], 0.3125, 5.0 * std::sqrt(0.625 * 0.25 / kRays));
}

class CoverageAgreementTest : public GpuTest, public testing::WithParamInterface<JudgedScene> {};

// With the same random numbers, so that rays go the same ways but for rounding. Coincident surfaces
// and edges are decided by it.
TEST_P(CoverageAgreementTest, EqualButForSomePixels) {
    constexpr uint32_t kSide = 64;
    constexpr uint32_t kRays = 4;
    const Scene scene = projectScene(GetParam().path);
    const RenderSettings settings = coverageSettings(kSide, kSide);
    const Coverage found = coverageOf(scene, settings, kRays);
    const reference::ReferenceTracer tracer(scene, {kSide, kSide}, 0);
    const MatteNames names = objectNames(scene);
    Coverage expected(kSide * kSide);
    referenceFeatures(tracer, settings, kRays, 2, {},
                      [&](auto ray) { expected.addRay(ray, names.ofPrimitives); });
    size_t differing = 0;
    size_t shown = 0;
    for (size_t i = 0; i < found.pixelCount(); ++i) {
        const auto a = found.ranked(i);
        const auto b = expected.ranked(i);
        const auto isSame = [](const Coverage::Share& s, const Coverage::Share& t) {
            return s.thing == t.thing && s.share == t.share;
        };
        differing += std::ranges::equal(a, b, isSame) ? 0 : 1;
        shown += a.size();
    }
    EXPECT_GT(shown, 0u);
    EXPECT_LE(static_cast<double>(differing),
              GetParam().mostDiffering * kRays * kSide * kSide + 1.0);
}

INSTANTIATE_TEST_SUITE_P(Scenes, CoverageAgreementTest,
                         testing::Values(kJudgedScenes[0], kJudgedScenes[1], kJudgedScenes[9],
                                         kJudgedScenes[18]),
                         [](const auto& scene) { return std::string(scene.param.name); });

} // namespace
} // namespace calotype::test
