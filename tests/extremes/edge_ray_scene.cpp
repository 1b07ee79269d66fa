#include "extremes/edge_ray_scene.h"

#include <algorithm>
#include <sstream>

#include "kernels/edge_rays.spv.h"
#include "support/gpu_test.h"

namespace calotype::test {
namespace {

constexpr uint32_t kGroups = 512;
constexpr uint32_t kBatches = kGroups * 64;
constexpr uint64_t kRaysPerDispatch = uint64_t{kBatches} * shared::kRaysPerEdgeBatch;

Buffer hostBuffer(size_t bytes, const char* name) {
    return Buffer(testDevice(), bytes, vk::BufferUsageFlagBits::eStorageBuffer,
                  Buffer::Memory::Host, name);
}

std::vector<Binding> withArrays(std::vector<Binding> bindings, const Buffer& in,
                                const Buffer& out) {
    bindings.push_back(Binding::storageBuffer(shared::kBindingEdgeBatches, in));
    bindings.push_back(Binding::storageBuffer(shared::kBindingEdgeEscapes, out));
    return bindings;
}

std::string describe(const shared::EdgeEscapes& escapes) {
    std::ostringstream text;
    text.precision(9);
    for (const glm::vec3& v : {escapes.origin, escapes.direction})
        text << "(" << v.x << ", " << v.y << ", " << v.z << ") ";
    return text.str();
}

} // namespace

EdgeRayScene::EdgeRayScene(const GpuScene& packed, const glm::dvec3& center, Directions directions)
    : sceneBuffers_(testDevice(), packed),
      batches_(hostBuffer(kBatches * sizeof(shared::EdgeBatch), "edge batches")),
      escapes_(hostBuffer(kBatches * sizeof(shared::EdgeEscapes), "edge escapes")),
      pipeline_(testDevice(),
                {.name = "edge rays",
                 .spirv = kEdgeRaysSpirv,
                 .bindings = withArrays(sceneBuffers_.bindings(), batches_, escapes_),
                 .constants = {packed.features.enabled.begin(), packed.features.enabled.end()}}) {
    batch_.center = packPosition(center, packed.origin);
    batch_.innermost = 0.9f;
    batch_.triangleCount = static_cast<uint32_t>(packed.triangles.size());
    batch_.hasUnitRays = directions == Directions::UnitLength ? 1 : 0;
}

EdgeRayScene::Escapes EdgeRayScene::cast(uint64_t rays) const {
    Escapes escapes;
    for (uint32_t seed = 0; escapes.rays < rays; ++seed)
        addDispatch(seed, escapes);
    return escapes;
}

void EdgeRayScene::addDispatch(uint32_t seed, Escapes& escapes) const {
    shared::EdgeBatch batch = batch_;
    batch.seed = seed;
    std::ranges::fill(batches_.mapped<shared::EdgeBatch>(), batch);
    pipeline_.run(testDevice(), kGroups);
    for (const shared::EdgeEscapes& result : escapes_.mapped<shared::EdgeEscapes>()) {
        escapes.count += result.count;
        escapes.mostIterations = std::max(escapes.mostIterations, result.iterations);
        if (result.count > 0)
            escapes.last = describe(result);
    }
    escapes.rays += kRaysPerDispatch;
}

} // namespace calotype::test
