// Rays of a picture, listed.
#include <glm/geometric.hpp>

#include "pack/gpu_scene.h"
#include "render/ray_list.h"
#include "support/gpu_test.h"
#include "support/scene_builder.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

/// A floor below a lamp, the upper half of the picture empty.
class RayListTest : public GpuTest {
protected:
    static constexpr uint32_t kWidth = 48;
    static constexpr uint32_t kHeight = 20; // not a multiple of a tile's side

    RayListTest() : packed_(packAsProgram(floorAndLamp()).packed), buffers_(testDevice(), packed_) {
        settings_.width = kWidth;
        settings_.height = kHeight;
        settings_.sampler = Sampler::Independent;
    }

    std::vector<shared::ListedRay> list(RayKind kind) const {
        return listRays(testDevice(), packed_, buffers_, settings_, kind);
    }

    uint32_t hitsOf(RayKind kind) const {
        const std::vector<shared::ListedRay> rays = list(kind);
        RayListTracer tracer(testDevice(), packed_, buffers_, rays, kind);
        tracer.trace();
        uint32_t hits = 0;
        for (const shared::ListedHit& hit : tracer.hits())
            hits += hit.primitive != shared::kNone ? 1 : 0;
        return hits;
    }

private:
    static Scene floorAndLamp() {
        SceneBuilder builder;
        const uint32_t grey = builder.material(0.5, 0.0);
        builder.rectangle({-50, -1, 50}, {100, 0, 0}, {0, 0, -100}, grey);
        builder.rectangle({-1, 3, -6}, {2, 0, 0}, {0, 0, 2}, builder.material(0.0, 5.0));
        builder.scene().camera.verticalFov = 0.5;
        builder.scene().camera.position = {0, 0, 0};
        return builder.scene();
    }

    GpuScene packed_;
    SceneBuffers buffers_;
    RenderSettings settings_;
};

TEST_F(RayListTest, EveryPixelHasAPrimaryRayFromTheCamera) {
    const std::vector<shared::ListedRay> rays = list(RayKind::afterBounces(0));
    ASSERT_EQ(rays.size(), kWidth * kHeight);
    for (const shared::ListedRay& ray : rays) {
        EXPECT_EQ(ray.origin, rays.front().origin);
        EXPECT_NEAR(glm::length(ray.direction), 1.0f, 1e-6f);
        EXPECT_LT(ray.direction.z, 0.0f);
    }
    EXPECT_NEAR(hitsOf(RayKind::afterBounces(0)), kWidth * kHeight / 2, kWidth);
}

TEST_F(RayListTest, ShadowRaysLeaveTheFloorForTheLamp) {
    const std::vector<shared::ListedRay> rays = list(RayKind::shadow());
    EXPECT_NEAR(static_cast<double>(rays.size()), kWidth * kHeight / 2, kWidth);
    for (const shared::ListedRay& ray : rays) {
        EXPECT_NE(ray.target, shared::kNone);
        EXPECT_NEAR((ray.tMax * ray.direction).y, 4.0f, 1e-4f); // from the floor to the lamp
    }
    EXPECT_EQ(hitsOf(RayKind::shadow()), 0u);
}

// Between an open floor and a lamp above it no path scatters three times.
TEST_F(RayListTest, NoPathBouncesThreeTimesOffAnOpenFloor) {
    EXPECT_TRUE(list(RayKind::afterBounces(3)).empty());
}

} // namespace
} // namespace calotype::test
