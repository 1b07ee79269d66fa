#include "kernels/light_sample.spv.h"
#include "render/scene_buffers.h"
#include "support/chi_square.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

class LightChoiceTest : public GpuTest {};

TEST_F(LightChoiceTest, HappensWithTheSelectionChances) {
    // Powers over three orders of magnitude.
    std::vector<Shape> shapes;
    RandomNumbers random(35);
    for (uint32_t i = 0; i < 37; ++i)
        shapes.push_back(shapeOf(
            Sphere{{glm::dmat3(1.0), 10.0 * random.inBall()}, random.powerOfTen(-1.5, 0.0)}));
    Scene scene = sceneOf(shapes);
    scene.materials[0].emission = glm::dvec3(1.0);
    const GpuScene packed = packAsProgram(scene).packed;
    ASSERT_EQ(packed.lightCount, shapes.size());

    std::vector<shared::TestLightQuery> queries;
    for (uint32_t i = 0; i < 1'000'000; ++i)
        queries.push_back({{},
                           0,
                           {0.0f, 0.0f, random.deviceUnit(), random.deviceUnit()},
                           packed.lightCount,
                           0,
                           0,
                           0});
    queries[0].u.z = queries[0].u.w = queries[1].u.z = queries[2].u.w = 1.0f - 0x1p-24f;
    const SceneBuffers buffers(testDevice(), packed);
    const auto results = runKernel<shared::TestLightSample>(kLightSampleSpirv, queries,
                                                            buffers.bindings(), kTestInputBinding);
    std::vector<uint64_t> counts(packed.lightCount);
    for (const shared::TestLightSample& result : results) {
        ASSERT_LT(result.chosen, packed.lightCount);
        ++counts[result.chosen];
    }
    std::vector<double> chances;
    for (const shared::Light& light : packed.lights)
        chances.push_back(light.selectionProbability);
    EXPECT_LT(chiSquare(counts, chances), chiSquareLimit(counts.size() - 1));
}

} // namespace
} // namespace calotype::test
