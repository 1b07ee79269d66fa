#include "support/primitive_scene.h"

#include <sstream>

#include "kernels/offset_from_surface.spv.h"
#include "kernels/primitive_hit.spv.h"
#include "kernels/traverse.spv.h"
#include "render/scene_buffers.h"
#include "support/gpu_test.h"
#include "support/oracle_quadric.h"

namespace calotype::test {
namespace {

template <typename T>
void fillIfEmpty(std::vector<T>& array) {
    if (array.empty())
        array.emplace_back();
}

/// Every array of a packed scene holds at least one element.
GpuScene complete(GpuScene scene) {
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) SCENE_ROWS(id, shared::type, member, people)
#define SCENE_ROWS(id, type, member, people) fillIfEmpty(scene.member);
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    scene.triangleNormals.resize(scene.triangles.size());
    scene.triangleUvs.resize(scene.triangles.size());
    return scene;
}

} // namespace

PrimitiveScene::PrimitiveScene(GpuScene scene) : scene_(complete(std::move(scene))) {}

PrimitiveScene PrimitiveScene::ofQuadrics(std::vector<shared::Quadric> quadrics) {
    GpuScene scene;
    scene.quadrics = std::move(quadrics);
    return PrimitiveScene(std::move(scene));
}

PrimitiveScene PrimitiveScene::ofTriangles(std::vector<shared::Triangle> triangles) {
    GpuScene scene;
    scene.triangles = std::move(triangles);
    return PrimitiveScene(std::move(scene));
}

std::vector<shared::TestHit> PrimitiveScene::hits(const std::vector<shared::TestRay>& rays) const {
    const SceneBuffers buffers(testDevice(), scene_);
    return runKernel<shared::TestHit>(kPrimitiveHitSpirv, rays, buffers.bindings(),
                                      kTestInputBinding);
}

std::vector<PrimitiveScene::Traversed>
PrimitiveScene::traverse(const std::vector<shared::TestRay>& rays) const {
    const SceneBuffers buffers(testDevice(), scene_);
    return runKernel<Traversed>(kTraverseSpirv, rays, buffers.bindings(), kTestInputBinding);
}

std::vector<glm::vec3> offsetPoints(const std::vector<shared::TestOffset>& points) {
    const auto rows = runKernel<glm::vec4>(kOffsetFromSurfaceSpirv, points);
    return {rows.begin(), rows.end()};
}

std::string describe(const shared::Quadric& quadric, const shared::TestRay& ray, float t) {
    std::ostringstream text;
    text.precision(9);
    const auto put = [&](const char* name, const glm::vec3& v) {
        text << name << " (" << v.x << ", " << v.y << ", " << v.z << ") ";
    };
    put("center", quadric.center);
    put("axis x", quadric.axisX);
    put("axis y", quadric.axisY);
    put("axis z", quadric.axisZ);
    text << "radius " << quadric.radius << " extent " << quadric.extent << " slope "
         << quadric.slope << "; ";
    put("origin", ray.origin);
    put("direction", ray.direction);
    text << "t " << t << ", exactly " << firstHit(quadric, lineOf(ray));
    return text.str();
}

} // namespace calotype::test
