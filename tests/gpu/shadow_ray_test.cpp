#include <algorithm>

#include "support/gpu_test.h"
#include "support/oracle_quadric.h"
#include "support/primitive_scene.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

// Shadow rays between two points of a closed room, both ends moved off their surfaces and the
// target primitive left out, as directLight casts them.

namespace calotype::test {
namespace {

constexpr uint32_t kRays = 100'000;

/// Points on the inside of a closed scene: where rays from a ball about the origin end, moved
/// inward.
struct WallPoints {
    std::vector<glm::vec3> positions;
    std::vector<uint32_t> primitives;
};

WallPoints wallPoints(const PrimitiveScene& scene, double radius, RandomNumbers& random) {
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < 2 * kRays; ++i)
        rays.push_back(testRay(radius * random.inBall(), random.direction(), shared::kNone));
    const auto found = scene.traverse(rays);
    for (size_t i = 0; i < rays.size(); ++i)
        rays[i].primitive = found[i].primitive;
    std::erase_if(rays, [](const auto& ray) { return ray.primitive == shared::kNone; });
    EXPECT_EQ(rays.size(), 2 * kRays) << "rays escaped from the room";
    std::vector<shared::TestOffset> offsets;
    WallPoints points;
    for (const shared::TestHit& hit : scene.hits(rays)) {
        offsets.push_back({hit.position, hit.error, -hit.ng, 0.0f});
        points.primitives.push_back(hit.primitive);
    }
    points.positions = offsetPoints(offsets);
    return points;
}

/// One ray from each point of the first half to one of the second.
std::vector<shared::TestRay> shadowRays(const WallPoints& points) {
    std::vector<shared::TestRay> rays;
    const size_t half = points.positions.size() / 2;
    for (size_t i = 0; i < half; ++i) {
        const glm::vec3 origin = points.positions[i];
        shared::TestRay ray =
            testRay(glm::dvec3(origin), glm::dvec3(points.positions[i + half] - origin),
                    points.primitives[i + half]);
        ray.tMax = 1.0f;
        ray.anyHit = 1;
        rays.push_back(ray);
    }
    return rays;
}

class ShadowRayTest : public GpuTest {
protected:
    static uint32_t blockedIn(const Mesh& room, double innerRadius) {
        const PrimitiveScene scene(packAsProgram(sceneOf({shapeOf(room)})).packed);
        RandomNumbers random(81);
        const auto hits = scene.traverse(shadowRays(wallPoints(scene, innerRadius, random)));
        return static_cast<uint32_t>(std::count_if(hits.begin(), hits.end(), [](const auto& hit) {
            return hit.primitive != shared::kNone;
        }));
    }
};

TEST_F(ShadowRayTest, IsNotBlockedInAConvexRoom) {
    for (const double radius : {1e-3, 1.0, 1e3})
        EXPECT_EQ(blockedIn(icosphere(4, glm::dvec3(0.0), radius), 0.5 * radius), 0u) << radius;
    EXPECT_EQ(blockedIn(cubeMesh(4), 0.5), 0u); // neighbours in one plane
}

TEST_F(ShadowRayTest, IsBlockedByWhatLiesBetween) {
    // The obstacle stands off the middle, so that most ends of the rays lie on the room.
    const Shape room = shapeOf(Sphere{{}, 3.0});
    const Shape obstacle = shapeOf(Sphere{{glm::dmat3(1.0), {2.0, 0.0, 0.0}}, 0.5});
    const GpuScene packed = packAsProgram(sceneOf({room, obstacle})).packed;
    const PrimitiveScene scene(packed);
    RandomNumbers random(82);
    const std::vector<shared::TestRay> rays = shadowRays(wallPoints(scene, 1.0, random));
    const auto hits = scene.traverse(rays);
    const shared::Quadric& between = packed.quadrics[packed.quadrics[0].id == 1 ? 0 : 1];
    uint32_t blockedRays = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        if (packed.quadrics[rays[i].primitive & ~shared::kQuadricBit].id == 1)
            continue; // its target is the obstacle itself
        const AllowedAnswers allowed =
            allowedAnswers(between, lineOf(rays[i]), 16.0L * kRoundoff * 6.0L);
        const bool blocked = hits[i].primitive != shared::kNone;
        blockedRays += blocked ? 1 : 0;
        EXPECT_TRUE(blocked ? !allowed.entry.isEmpty() || !allowed.exit.isEmpty() : allowed.miss);
    }
    EXPECT_GT(blockedRays, 1000u);
}

} // namespace
} // namespace calotype::test
