#include <glm/geometric.hpp>

#include "render/ray_list.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/oracle_quadric.h"
#include "support/oracle_triangle.h"
#include "support/primitive_scene.h"
#include "support/slow_run.h"
#include "support/test_quadrics.h"
#include "support/test_scenes.h"

// Whole scenes, packed as the program packs them, against every primitive tried in turn. An answer
// is right if each primitive's surface may be off by 16 roundings of its distance (see
// quadric_hit_test.cpp and triangle_hit_test.cpp): the hit is one of its primitive's, and no other
// primitive must have been met before it.

namespace calotype::test {
namespace {

constexpr Real kAllowedRoundoffs = 16.0L;

glm::dmat3 someRotation(RandomNumbers& random) {
    return random.coin() ? glm::dmat3(1.0) : randomRotation(random);
}

Shape randomShape(const glm::dvec3& center, double size, RandomNumbers& random) {
    const RigidTransform frame{someRotation(random), center};
    switch (random.below(5)) {
    case 0:
        return shapeOf(Sphere{frame, size});
    case 1:
        return shapeOf(Cylinder{frame, size * random.between(0.1, 1.0), size});
    case 2:
        return shapeOf(Cone{frame, random.sign() * size, random.powerOfTen(-1.0, 0.5)});
    case 3:
        return shapeOf(Disk{frame, size});
    default:
        return shapeOf(singleTriangle(center + size * random.inBall(),
                                      center + size * random.inBall(),
                                      center + size * random.inBall()));
    }
}

/// What the loops of the rendering kernels find.
std::vector<PrimitiveScene::Traversed>
traceList(const GpuScene& scene, const std::vector<shared::TestRay>& rays, RayKind kind) {
    std::vector<shared::ListedRay> listed;
    for (const shared::TestRay& ray : rays)
        listed.push_back({ray.origin, ray.tMax, ray.direction, shared::kNone});
    const SceneBuffers buffers(testDevice(), scene);
    RayListTracer tracer(testDevice(), scene, buffers, listed, kind);
    tracer.trace();
    std::vector<PrimitiveScene::Traversed> found;
    for (const shared::ListedHit& hit : tracer.hits())
        found.push_back({hit.t, hit.primitive, 0, 0});
    return found;
}

enum class Arrangement { Scattered, Clustered, Coincident };

struct Crowd {
    std::string name;
    uint32_t count;
    Arrangement arrangement;
};

std::vector<Shape> makeCrowd(const Crowd& crowd, RandomNumbers& random) {
    std::vector<Shape> shapes;
    const double spacing = 1.0 / std::cbrt(crowd.count);
    for (uint32_t i = 0; i < crowd.count; ++i) {
        if (crowd.arrangement == Arrangement::Coincident && i % 3 != 0) {
            shapes.push_back(shapes.back());
        } else if (crowd.arrangement == Arrangement::Clustered) {
            const double scale = std::pow(10.0, double(i % 5) - 3.0);
            const glm::dvec3 place = scale * glm::dvec3(1.0, double(i % 3), -1.0);
            shapes.push_back(randomShape(place + scale * random.inBall(), scale * spacing, random));
        } else {
            shapes.push_back(randomShape(random.inBall(), spacing, random));
        }
    }
    return shapes;
}

AllowedAnswers triangleAnswers(const shared::Triangle& triangle, const Line& line) {
    const TriangleCrossing crossing = crossTriangle(triangle, line);
    const Real margin = kAllowedRoundoffs * kRoundoff * crossing.reach;
    const Real tError = 8.0L * margin * crossing.magnification / glm::length(line.direction);
    AllowedAnswers allowed;
    allowed.miss = crossing.insideBy < margin || crossing.t < tError;
    if (crossing.insideBy > -margin)
        allowed.entry = {crossing.t - tError, crossing.t + tError};
    return allowed;
}

class BruteForce {
public:
    explicit BruteForce(const GpuScene& scene) : scene_(scene) {}

    /// The sentence that says what is wrong with an answer; empty if nothing is.
    std::string judge(const shared::TestRay& ray, const PrimitiveScene::Traversed& hit) const {
        const Line line = lineOf(ray);
        const Real reached = hit.primitive == shared::kNone ? Real(ray.tMax) : Real(hit.t);
        if (hit.primitive != shared::kNone && !answersOf(hit.primitive, line).contains(hit.t))
            return "the primitive is not there";
        for (const uint32_t primitive : names()) {
            const AllowedAnswers allowed = answersOf(primitive, line);
            if (!allowed.miss && std::max(allowed.entry.leave, allowed.exit.leave) < reached)
                return "primitive " + std::to_string(primitive) + " was missed";
        }
        return {};
    }

private:
    std::vector<uint32_t> names() const {
        std::vector<uint32_t> result;
        for (uint32_t i = 0; i < scene_.triangles.size(); ++i)
            result.push_back(i);
        for (uint32_t i = 0; i < scene_.quadrics.size(); ++i)
            result.push_back(i | shared::kQuadricBit);
        return result;
    }

    AllowedAnswers answersOf(uint32_t primitive, const Line& line) const {
        if ((primitive & shared::kQuadricBit) == 0)
            return triangleAnswers(scene_.triangles[primitive], line);
        const shared::Quadric& quadric = scene_.quadrics[primitive & ~shared::kQuadricBit];
        const Real scale = roundingScale(quadric, line, firstHit(quadric, line));
        return allowedAnswers(quadric, line, kAllowedRoundoffs * kRoundoff * scale);
    }

    const GpuScene& scene_;
};

/// Rays from in and around the unit ball; every third one along an axis.
std::vector<shared::TestRay> makeRays(uint32_t count, RandomNumbers& random) {
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < count; ++i) {
        glm::dvec3 direction = random.direction();
        if (i % 3 == 0) {
            direction = glm::dvec3(random.coin() ? 0.0 : -0.0);
            direction[static_cast<int>(random.below(3))] =
                random.sign() * random.powerOfTen(-2.0, 2.0);
        }
        rays.push_back(testRay(2.0 * random.inBall(), direction, shared::kNone));
    }
    return rays;
}

class TraversalTest : public GpuTest, public testing::WithParamInterface<Crowd> {};

TEST_P(TraversalTest, FindsWhatBruteForceFinds) {
    const uint32_t tests = quickOrFull(1'000'000u, 3'000'000u); // of primitives against rays
    RandomNumbers random(41);
    const Scene scene = sceneOf(makeCrowd(GetParam(), random));
    const PackedScene built = packAsProgram(scene);
    ASSERT_EQ(findBvhDefect(built.bvh, built.primitives), std::nullopt);
    const PrimitiveScene onDevice(built.packed);
    const BruteForce oracle(built.packed);

    std::vector<shared::TestRay> rays =
        makeRays(std::min(20'000u, tests / GetParam().count), random);
    const auto closest = onDevice.traverse(rays);
    const auto closestOfList = traceList(built.packed, rays, RayKind::afterBounces(0));
    uint32_t hits = 0;
    for (size_t i = 0; i < rays.size(); ++i) {
        hits += closest[i].primitive != shared::kNone ? 1 : 0;
        ASSERT_EQ(oracle.judge(rays[i], closest[i]), "") << "ray " << i;
        ASSERT_EQ(oracle.judge(rays[i], closestOfList[i]), "") << "listed ray " << i;
    }
    RecordProperty("hits", std::to_string(hits));

    // Any hit: up to just before, or just beyond, what was found.
    for (size_t i = 0; i < rays.size(); ++i) {
        rays[i].anyHit = 1;
        rays[i].tMax =
            closest[i].primitive == shared::kNone ? kFar : closest[i].t * (i % 2 ? 1.001f : 1.0f);
    }
    const auto any = onDevice.traverse(rays);
    const auto anyOfList = traceList(built.packed, rays, RayKind::shadow());
    for (size_t i = 0; i < rays.size(); ++i) {
        const bool reaches = closest[i].primitive != shared::kNone && i % 2 == 1;
        ASSERT_EQ(any[i].primitive != shared::kNone, reaches) << "ray " << i;
        ASSERT_EQ(anyOfList[i].primitive != shared::kNone, reaches) << "listed ray " << i;
    }
}

const Crowd kCrowds[] = {{"One", 1, Arrangement::Scattered},
                         {"Two", 2, Arrangement::Scattered},
                         {"Five", 5, Arrangement::Scattered},
                         {"Hundred", 100, Arrangement::Scattered},
                         {"TwoThousand", 2000, Arrangement::Scattered},
                         {"Clusters", 500, Arrangement::Clustered},
                         {"Coincident", 300, Arrangement::Coincident}};
const auto nameOfCrowd = [](const auto& instance) { return instance.param.name; };
INSTANTIATE_TEST_SUITE_P(Of, TraversalTest, testing::ValuesIn(kCrowds), nameOfCrowd);
INSTANTIATE_TEST_SUITE_P(SlowOf, TraversalTest, testing::ValuesIn(kCrowds), nameOfCrowd);

class TraversalCostTest : public GpuTest {};

TEST_F(TraversalCostTest, OfAxisAlignedRaysStaysLow) {
    // 98,304 triangles in six flat sides, all boxes flat: rays with exact zeros in their direction,
    // at the edges of boxes as well as between them. The tree is 15 deep.
    const PrimitiveScene scene(packAsProgram(sceneOf({shapeOf(cubeMesh(128))})).packed);
    RandomNumbers random(42);
    std::vector<shared::TestRay> rays;
    for (uint32_t i = 0; i < 20'000; ++i) {
        glm::dvec3 origin;
        for (int axis = 0; axis < 3; ++axis)
            origin[axis] =
                random.coin() ? (random.below(127) - 63.0) / 64.0 : random.between(-0.99, 0.99);
        glm::dvec3 direction(random.coin() ? 0.0 : -0.0);
        direction[static_cast<int>(random.below(3))] = random.sign();
        // One ray alone in its subgroup, whose iterations are counted together.
        for (uint32_t copy = 0; copy < 8; ++copy)
            rays.push_back(testRay(origin, direction, shared::kNone));
    }
    uint32_t most = 0;
    for (const auto& hit : scene.traverse(rays)) {
        ASSERT_NE(hit.primitive, shared::kNone);
        most = std::max(most, hit.iterations);
    }
    RecordProperty("iterations", std::to_string(most));
    EXPECT_LT(most, 100u);
}

} // namespace
} // namespace calotype::test
