// A scene is compiled for the settings of a render.
#include "engine/compile_scene.h"

#include <gtest/gtest.h>

#include "engine/scene_settings.h"
#include "support/scene_builder.h"

namespace calotype::test {
namespace {

constexpr uint32_t kPrimitives = 100;

Scene manyBalls() {
    SceneBuilder builder;
    const uint32_t grey = builder.material(0.5, 1.0);
    for (uint32_t i = 0; i < kPrimitives; ++i)
        builder.add(makeShape(Sphere{{glm::dmat3(1.0), {3.0 * i, 0.0, -5.0}}, 1.0}, grey));
    return builder.scene();
}

// Surfaces that coincide are hit in the order of the BVH, so a crop shows the pixels of the whole
// picture only with its BVH.
TEST(CompileSceneTest, CropsHaveTheTreeOfTheWholePicture) {
    const Scene scene = manyBalls();
    RenderSettings settings = defaultSettings(scene);
    settings.samplesPerPixel = 1;
    ASSERT_GT(settings.width * settings.height, kPrimitives);
    const CompiledScene whole = compileScene(scene, settings);
    settings.crop = Crop{3, 4, 1, 1};
    const CompiledScene crop = compileScene(scene, settings);
    EXPECT_EQ(whole.builder, BvhBuilder::Sah);
    EXPECT_EQ(crop.builder, BvhBuilder::Sah);
}

TEST(CompileSceneTest, FewPathsTakeTheTreeThatIsBuiltSooner) {
    const Scene scene = manyBalls();
    RenderSettings settings = defaultSettings(scene);
    settings.samplesPerPixel = 1;
    settings.width = settings.height = 8;
    settings.crop = Crop{0, 0, 8, 8};
    EXPECT_EQ(compileScene(scene, settings).builder, BvhBuilder::Median);
}

} // namespace
} // namespace calotype::test
