// Needles and slivers: closed meshes made of them let no ray out. (tests/gpu/triangle_hit_test.cpp
// holds single ones to the oracle.)
#include <cmath>
#include <iostream>

#include "extremes/closed_meshes.h"
#include "extremes/edge_ray_scene.h"
#include "support/gpu_test.h"
#include "support/slow_run.h"
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
    const uint64_t rays = quickOrFull(250'000, 1'000'000);
    EXPECT_EQ(escapesOf(box, rays), 0u);
    EXPECT_EQ(escapesOf(turned(box), rays), 0u);
}

TEST_P(SliversTest, OfLongTubesLetNoRayOut) {
    const glm::dvec3 thin(1.0, GetParam(), GetParam());
    const uint64_t rays = quickOrFull(250'000, 500'000);
    EXPECT_EQ(escapesOf(stretched(cubeMesh(8), thin), rays), 0u);
    EXPECT_EQ(escapesOf(stretched(icosphere(3, {}, 1.0), thin), rays), 0u);
}

const auto kWidths = testing::Values(1e-3, 1e-4, 1e-5, 1e-6, 1e-7);
const auto nameOfWidth = [](const auto& width) {
    return "Width1em" + std::to_string(std::lround(-std::log10(width.param)));
};
INSTANTIATE_TEST_SUITE_P(Of, SliversTest, kWidths, nameOfWidth);
INSTANTIATE_TEST_SUITE_P(SlowOf, SliversTest, kWidths, nameOfWidth);

} // namespace
} // namespace calotype::test
