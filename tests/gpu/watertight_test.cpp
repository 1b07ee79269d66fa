#include "support/gpu_test.h"
#include "support/primitive_scene.h"
#include "support/random_numbers.h"
#include "support/test_scenes.h"

// No ray leaves a closed mesh: rays from inside, aimed at corners and at points of edges, where the
// next triangle has to take what its neighbour refuses.

namespace calotype::test {
namespace {

constexpr uint32_t kRaysPerBatch = 250'000;

/// A point of a random edge: a corner for every third ray.
glm::dvec3 edgePoint(const Mesh& mesh, RandomNumbers& random) {
    const auto& triangle = mesh.triangles[random.below(uint32_t(mesh.triangles.size()))];
    const uint32_t corner = random.below(3);
    const glm::dvec3 from = mesh.positions[triangle.position[corner]];
    const glm::dvec3 to = mesh.positions[triangle.position[(corner + 1) % 3]];
    return random.below(3) == 0 ? from : glm::mix(from, to, random.unit());
}

uint32_t countEscapes(const PrimitiveScene& scene, const std::vector<shared::TestRay>& rays) {
    uint32_t escapes = 0;
    for (const auto& hit : scene.traverse(rays))
        escapes += hit.primitive == shared::kNone ? 1 : 0;
    return escapes;
}

class ClosedMeshTest : public GpuTest {
protected:
    /// Escapes of `batches` batches of rays from inside the ball of `innerRadius`.
    static uint32_t escapesFrom(const Mesh& mesh, double innerRadius, uint32_t batches) {
        const PackedScene packed = packAsProgram(sceneOf({shapeOf(mesh)}));
        const PrimitiveScene scene(packed.packed);
        const glm::vec3 shift(packed.packed.origin);
        RandomNumbers random(11);
        uint32_t escapes = 0;
        for (uint32_t batch = 0; batch < batches; ++batch) {
            std::vector<shared::TestRay> rays;
            for (uint32_t i = 0; i < kRaysPerBatch; ++i) {
                const glm::vec3 origin(innerRadius * random.inBall());
                const glm::vec3 target = glm::vec3(edgePoint(mesh, random)) - shift;
                rays.push_back(
                    testRay(glm::dvec3(origin), glm::dvec3(target - origin), shared::kNone));
            }
            escapes += countEscapes(scene, rays);
        }
        return escapes;
    }
};

TEST_F(ClosedMeshTest, OfSharedCornersLetsNoRayOut) {
    EXPECT_EQ(escapesFrom(icosphere(5, glm::dvec3(0.0), 1.0), 0.9, 6), 0u);
}

TEST_F(ClosedMeshTest, OfThousandthSizedTrianglesLetsNoRayOut) {
    EXPECT_EQ(escapesFrom(icosphere(8, glm::dvec3(0.0), 1.0), 0.9, 1), 0u);
}

TEST_F(ClosedMeshTest, WithFlatAxisAlignedBoxesLetsNoRayOut) {
    EXPECT_EQ(escapesFrom(cubeMesh(24), 0.9, 4), 0u);
}

TEST_F(ClosedMeshTest, LetsNoAxisAlignedRayOutAlongItsEdges) {
    const Mesh cube = cubeMesh(32);
    const PrimitiveScene scene(packAsProgram(sceneOf({shapeOf(cube)})).packed);
    std::vector<shared::TestRay> rays;
    RandomNumbers random(12);
    for (uint32_t i = 0; i < kRaysPerBatch; ++i) {
        // The corners are multiples of 1/16, so the ray runs exactly at one, or along an edge.
        const auto onGrid = [&] { return (random.below(31) - 15.0) / 16.0; };
        const auto axis = static_cast<int>(random.below(3));
        glm::dvec3 origin(onGrid(), onGrid(), onGrid());
        origin[(axis + 1) % 3] = random.coin() ? origin[(axis + 1) % 3] : random.between(-0.9, 0.9);
        glm::dvec3 direction(random.coin() ? 0.0 : -0.0);
        direction[axis] = random.sign();
        if (random.coin()) // or tilted by next to nothing
            direction[(axis + 2) % 3] = random.sign() * random.powerOfTen(-20.0, -3.0);
        rays.push_back(testRay(origin, direction, shared::kNone));
    }
    EXPECT_EQ(countEscapes(scene, rays), 0u);
}

} // namespace
} // namespace calotype::test
