// Needles and slivers: closed meshes made of them let no ray out. (tests/gpu/triangle_hit_test.cpp
// holds single ones to the oracle.)
#include <cmath>
#include <iostream>

#include "extremes/closed_meshes.h"
#include "extremes/edge_ray_scene.h"
#include "support/gpu_test.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

/// Width over length.
class SliversTest : public GpuTest, public testing::WithParamInterface<double> {
protected:
    static uint64_t escapesOf(const Mesh& mesh, uint64_t rays) {
        const EdgeRayScene scene(packAsProgram(sceneOf({shapeOf(mesh)})).packed, {});
        const EdgeRayScene::Escapes escapes = scene.cast(rays);
        EXPECT_LT(escapes.mostIterations, 65'000u) << "llvmpipe ends loops there";
        std::cout << escapes.rays << " rays, " << escapes.count << " escaped " << escapes.last
                  << "\n";
        return escapes.count;
    }
};

TEST_P(SliversTest, OfClosedBoxesLetNoRayOut) {
    const Mesh box = boxWithCuts(sliverCuts(GetParam()));
    EXPECT_EQ(escapesOf(box, 1'000'000), 0u);
    EXPECT_EQ(escapesOf(turned(box), 1'000'000), 0u);
}

TEST_P(SliversTest, OfLongTubesLetNoRayOut) {
    const glm::dvec3 thin(1.0, GetParam(), GetParam());
    EXPECT_EQ(escapesOf(stretched(cubeMesh(8), thin), 500'000), 0u);
    EXPECT_EQ(escapesOf(stretched(icosphere(3, {}, 1.0), thin), 500'000), 0u);
}

INSTANTIATE_TEST_SUITE_P(Of, SliversTest, testing::Values(1e-3, 1e-4, 1e-5, 1e-6, 1e-7),
                         [](const auto& width) {
                             return "Width1em" +
                                    std::to_string(std::lround(-std::log10(width.param)));
                         });

} // namespace
} // namespace calotype::test
