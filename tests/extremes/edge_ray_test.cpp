// No ray leaves a closed mesh: rays from inside, aimed at corners and at points of edges, where the
// next triangle has to take what its neighbour refuses.
#include <cmath>
#include <iostream>

#include <glm/geometric.hpp>

#include "extremes/closed_meshes.h"
#include "extremes/edge_ray_scene.h"
#include "support/gpu_test.h"
#include "support/test_scenes.h"

namespace calotype::test {
namespace {

struct ClosedMesh {
    const char* name;
    Mesh (*make)();
    glm::dvec3 center; ///< from which the mesh is seen as a whole
};

/// A thousand times its size from the camera, about which the scene is packed.
constexpr glm::dvec3 kFarAway(1000.0, -2000.0, 1500.0);

const ClosedMesh kClosedMeshes[] = {
    {"Cube", [] { return cubeMesh(24); }, {}},
    {"PlainTurnedCube", [] { return turned(cubeMesh(1)); }, {}},
    {"TurnedCube", [] { return turned(cubeMesh(24)); }, {}},
    {"Ball", [] { return icosphere(5, glm::dvec3(0.0), 1.0); }, {}},
    {"DisplacedBall", [] { return displacedBall(5); }, {}},
    {"LongBox",
     [] {
         return stretched(cubeMesh(8), {1.0, 1e-3, 1e-3});
     },
     {}},
    {"LongBall",
     [] {
         return stretched(icosphere(4, {}, 1.0), {1.0, 1e-3, 1e-3});
     },
     {}},
    {"FlatTurnedBox",
     [] {
         return turned(stretched(cubeMesh(8), {1.0, 1e-3, 1.0}));
     },
     {}},
    {"FarBall", [] { return icosphere(5, kFarAway, 1.0); }, kFarAway},
    {"FarTurnedCube", [] { return moved(turned(cubeMesh(24)), kFarAway); }, kFarAway},
};
constexpr size_t kMeshCount = std::size(kClosedMeshes);

void PrintTo(const ClosedMesh& mesh, std::ostream* stream) { *stream << mesh.name; }

/// The mesh, and a speck at the camera, so that the packed scene's origin stays there.
Scene sceneAbout(const ClosedMesh& closed) {
    std::vector<Shape> shapes = {shapeOf(closed.make())};
    if (closed.center != glm::dvec3(0.0))
        shapes.push_back(shapeOf(Sphere{{}, 1e-9}));
    return sceneOf(std::move(shapes));
}

class EdgeRaysTest : public GpuTest, public testing::WithParamInterface<ClosedMesh> {
protected:
    /// Of so many rays in all meshes together.
    static void expectNoEscapes(uint64_t raysInAll) {
        const EdgeRayScene scene(packAsProgram(sceneAbout(GetParam())).packed, GetParam().center);
        const EdgeRayScene::Escapes escapes = scene.cast(raysInAll / kMeshCount);
        std::cout << escapes.rays << " rays, " << escapes.count << " escaped\n";
        EXPECT_EQ(escapes.count, 0u) << "one of them: " << escapes.last;
        EXPECT_LT(escapes.mostIterations, 65'000u) << "llvmpipe ends loops there";
    }
};

TEST_P(EdgeRaysTest, StayInClosedMeshes) { expectNoEscapes(10'000'000); }

using SlowEdgeRaysTest = EdgeRaysTest;
TEST_P(SlowEdgeRaysTest, StayInClosedMeshes) { expectNoEscapes(1'000'000'000); }

class EdgeRaysAtScaleTest : public GpuTest, public testing::WithParamInterface<int> {};

TEST_P(EdgeRaysAtScaleTest, StayInClosedMeshes) {
    constexpr uint64_t kRays = 500'000;
    const double size = std::pow(10.0, GetParam());
    for (const Mesh& mesh : {icosphere(5, glm::dvec3(0.0), 1.0), turned(cubeMesh(24))}) {
        const Scene scene = sceneOf({shapeOf(stretched(mesh, glm::dvec3(size)))});
        const EdgeRayScene::Escapes escapes =
            EdgeRayScene(packAsProgram(scene).packed, {}, EdgeRayScene::Directions::UnitLength)
                .cast(kRays);
        std::cout << "size " << size << ": " << escapes.count << " escaped of " << escapes.rays
                  << "\n";
        EXPECT_EQ(escapes.count, 0u) << "one of them: " << escapes.last;
    }
}

INSTANTIATE_TEST_SUITE_P(Of, EdgeRaysAtScaleTest,
                         testing::Values(-15, -12, -9, -6, -3, 3, 6, 9, 11), [](const auto& power) {
                             return (power.param < 0 ? "TenToMinus" : "TenTo") +
                                    std::to_string(std::abs(power.param));
                         });

const auto nameOfMesh = [](const auto& mesh) { return std::string(mesh.param.name); };
INSTANTIATE_TEST_SUITE_P(Of, EdgeRaysTest, testing::ValuesIn(kClosedMeshes), nameOfMesh);
INSTANTIATE_TEST_SUITE_P(Of, SlowEdgeRaysTest, testing::ValuesIn(kClosedMeshes), nameOfMesh);

} // namespace
} // namespace calotype::test
