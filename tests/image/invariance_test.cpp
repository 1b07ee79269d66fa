// What must not change the picture, and does not by a single bit.
#include <cmath>

#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/render_scene.h"
#include "support/scene_builder.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

class InvarianceTest : public GpuTest {
protected:
    /// Every kind of primitive and light, smooth normals, and a light hidden from the camera.
    static Scene everything() { return projectScene("tests/image/scenes/everything.json"); }

    static RenderWish small() {
        RenderWish wish;
        wish.width = 48;
        wish.height = 40;
        wish.samplesPerPixel = 20;
        return wish;
    }
};

void expectSamePixels(const Image& a, const Image& b) {
    ASSERT_EQ(a.width, b.width);
    ASSERT_EQ(a.height, b.height);
    size_t different = 0;
    for (size_t i = 0; i < a.pixels.size(); ++i)
        different += a.pixels[i] == b.pixels[i] ? 0 : 1;
    EXPECT_EQ(different, 0u);
    EXPECT_GT(imageMean(a).x, 0.01); // not two black pictures
}

// Specialising only removes code: for each scene, the kernel made for it and the kernel for all.
// The quick run takes two of them; feature_test.cpp takes a scene for each feature.
TEST_F(InvarianceTest, SpecialisedKernelEqualsEverythingOn) {
    std::vector<const char*> paths = {"scenes/cornell-box.json",
                                      "tests/image/scenes/everything.json"};
    if (isSlowRun())
        paths.insert(paths.end(), {"scenes/sphere.json", "scenes/cylinder.json", "scenes/cone.json",
                                   "scenes/disk.json", "scenes/mesh.json"});
    for (const char* path : paths) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        RenderWish wish = small();
        const Image specialised = renderScene(scene, wish).image;
        wish.features = SceneFeatures::all();
        expectSamePixels(specialised, renderScene(scene, wish).image);
    }
}
ALSO_SLOW(InvarianceTest, SpecialisedKernelEqualsEverythingOn);

// Where quadrics are few, rays wait with them; where they are many, they are met at once.
TEST_F(InvarianceTest, FewQuadricsAreMetAsManyAre) {
    Scene scene = everything();
    for (Material& material : scene.materials) // rays to lights pass triangles and quadrics
        if (material.name == "wall" || material.name == "blue")
            material.opacity = 0.6;
    for (const size_t i : {0, 1}) // so large that quadrics are few: the floor and the back
        for (glm::dvec3& position : std::get<Mesh>(scene.shapes[i].geometry).positions)
            position *= 5.0;
    RenderWish wish = small();
    const RenderedScene few = renderScene(scene, wish);
    ASSERT_FALSE(few.needed.enabled[shared::kFeatureManyQuadrics]);
    wish.features = few.needed;
    wish.features->enabled[shared::kFeatureManyQuadrics] = true;
    expectSamePixels(few.image, renderScene(scene, wish).image);
}

TEST_F(InvarianceTest, WhereTheStackLiesDoesNotMatter) {
    RenderWish wish = small();
    wish.tuning = KernelTuning{.sharesStack = false};
    const Image own = renderScene(everything(), wish).image;
    wish.tuning->sharesStack = true;
    expectSamePixels(own, renderScene(everything(), wish).image);
}

TEST_F(InvarianceTest, PassesDoNotMatter) {
    RenderWish wish = small();
    const Image whole = renderScene(everything(), wish).image;
    wish.passSamples = 3;
    expectSamePixels(whole, renderScene(everything(), wish).image);
}

TEST_F(InvarianceTest, CropIsAPartOfTheWhole) {
    RenderWish wish = small();
    const Image whole = renderScene(everything(), wish).image;
    wish.crop = Crop{13, 7, 21, 18};
    const Image crop = renderScene(everything(), wish).image;
    ASSERT_EQ(crop.width, 21u);
    ASSERT_EQ(crop.height, 18u);
    for (uint32_t y = 0; y < crop.height; ++y)
        for (uint32_t x = 0; x < crop.width; ++x)
            ASSERT_EQ(crop.at(x, y), whole.at(x + 13, y + 7)) << x << "," << y;
}

TEST_F(InvarianceTest, SeedsDiffer) {
    RenderWish wish = small();
    const Image first = renderScene(everything(), wish).image;
    wish.seed = 1;
    const Image second = renderScene(everything(), wish).image;
    EXPECT_NE(first.pixels, second.pixels);
}

// Paths of 20,000 events take many dispatches' budgets: they are put down and taken up again.
TEST_F(InvarianceTest, PathsBeyondTheLoopBudgetAreTakenUpAgain) {
    SceneBuilder builder;
    builder.material(1.0 - 1e-4, 1e-4);
    builder.material(0.0, 1.0, true); // a lamp outside, so that light is sampled in vain
    builder.add(makeShape(Sphere{{}, 1.0}, 0));
    builder.add(makeShape(Sphere{{glm::dmat3(1.0), {9.0, 0.0, 0.0}}, 1.0}, 1));
    Scene& scene = builder.scene();
    scene.film = {8, 8};
    scene.render = {2, 20000, 0};
    const RenderedScene result = renderScene(scene);
    EXPECT_EQ(result.totals.paths, 8u * 8u * 2u);
    EXPECT_EQ(result.totals.losses.cutPaths, 0u);
    EXPECT_NEAR(imageMean(result.image).x, 1.0 - std::pow(1.0 - 1e-4, 20001), 0.01);
}

// Stopped in its first pass, a session shows the pixels that have a sample, each divided by its own
// number of them: a black room that glows is exact where there is any.
TEST_F(InvarianceTest, PartialBlockIsDividedPixelByPixel) {
    SceneBuilder builder;
    builder.material(0.0, 0.75);
    builder.add(makeShape(Sphere{{}, 1.0}, 0));
    Scene& scene = builder.scene();
    scene.film = {256, 256};
    scene.render = {1 << 20, 2, 0};
    RenderWish wish;
    int dispatches = 0;
    wish.observer.shouldStop = [&] { return ++dispatches == 2; };
    size_t black = 0;
    size_t glowing = 0;
    for (const glm::vec3& pixel : renderScene(scene, wish).image.pixels) {
        black += pixel == glm::vec3(0.0f) ? 1 : 0;
        glowing += pixel == glm::vec3(0.75f) ? 1 : 0;
    }
    EXPECT_EQ(black + glowing, 256u * 256u);
    EXPECT_GT(black, 0u);
    EXPECT_GT(glowing, 0u);
}

// The picture of a session that was stopped after a few dispatches shows the samples it has.
TEST_F(InvarianceTest, StoppedSessionShowsWhatThereIs) {
    RenderWish wish = small();
    wish.samplesPerPixel = 1 << 20;
    int dispatches = 0;
    wish.observer.shouldStop = [&] { return ++dispatches == 12; };
    const RenderedScene stopped = renderScene(everything(), wish);
    EXPECT_EQ(dispatches, 12);
    EXPECT_GT(stopped.totals.paths, 0u);
    EXPECT_GT(imageMean(stopped.image).x, 0.01);
}

// Scattering 400 times in a closed room takes more loop iterations than llvmpipe allows a dispatch
// for a block of samples, so the work continues in another one; the mean is wrong if any is lost.
TEST_F(InvarianceTest, LongPathsSurviveTheLoopBudget) {
    SceneBuilder builder;
    builder.material(0.98, 0.02);
    builder.add(makeShape(Sphere{{}, 1.0}, 0));
    Scene& scene = builder.scene();
    scene.film = {16, 16};
    scene.render = {64, 400, 0};
    scene.camera.position = {0.1, 0.2, 0.15};
    int dispatches = 0;
    int passes = 0;
    RenderWish wish;
    wish.observer.onDispatch = [&](const RenderTotals&) { ++dispatches; };
    wish.observer.onPass = [&](const RenderTotals&) { ++passes; };
    const RenderedScene result = renderScene(scene, wish);
    if (testDevice().info().type == "CPU")
        EXPECT_GT(dispatches, passes); // four tiles fit into one dispatch but for the budget
    EXPECT_EQ(result.totals.losses.cutPaths, 0u);
    EXPECT_EQ(result.totals.paths, 16u * 16u * 64u);
    const double expected = 1.0 - std::pow(0.98, 401);
    EXPECT_NEAR(imageMean(result.image).x, expected, 0.01);
}

} // namespace
} // namespace calotype::test
