#include <array>
#include <cstring>

#include "kernels/layout_echo.spv.h"
#include "kernels/parked_task.h"
#include "render/scene_buffers.h"
#include "shared/bindings.h"
#include "shared/layers.h"
#include "shared/ray_structs.h"
#include "shared/render_structs.h"
#include "support/gpu_test.h"
#include "support/kernels/test_structs.h"

// What the host writes is what the kernels read, field by field and bit for bit.

namespace calotype::test {
namespace {

/// Fills structs with words that are all different (and normal floats, which no device flushes to
/// zero), and keeps them in order.
class DistinctWords {
public:
    template <typename T>
    T make() {
        static_assert(sizeof(T) % sizeof(uint32_t) == 0);
        std::vector<uint32_t> words;
        for (size_t i = 0; i < sizeof(T) / sizeof(uint32_t); ++i)
            words.push_back(0x40000000u + 0x00010305u * static_cast<uint32_t>(++made_));
        T result;
        std::memcpy(static_cast<void*>(&result), words.data(), sizeof(T));
        words_.insert(words_.end(), words.begin(), words.end());
        return result;
    }

    const std::vector<uint32_t>& words() const { return words_; }

private:
    size_t made_ = 0;
    std::vector<uint32_t> words_;
};

class LayoutTest : public GpuTest {};

TEST_F(LayoutTest, IsTheSameInHostAndKernel) {
    DistinctWords distinct;
    GpuScene scene;
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) scene.member = {{}, distinct.make<shared::type>()};
#define SCENE_ROWS(id, type, member, people)
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    scene.texelRows = {{}};
    const auto camera = distinct.make<shared::Camera>();
    struct Parameters {
        shared::RenderParameters render;
        shared::RecordParameters record;
    } parameters{};
    parameters.render = distinct.make<shared::RenderParameters>();
    parameters.record = distinct.make<shared::RecordParameters>();
    const auto rayList = distinct.make<shared::RayListParameters>();
    const auto counters = distinct.make<shared::RenderCounters>();
    const std::array records = {shared::FirstHitRecord{}, distinct.make<shared::FirstHitRecord>()};
    const std::array parked = {shared::ParkedTask{}, distinct.make<shared::ParkedTask>()};
    const std::array rays = {shared::ListedRay{}, distinct.make<shared::ListedRay>()};
    const std::array hits = {shared::ListedHit{}, distinct.make<shared::ListedHit>()};

    const Device& device = testDevice();
    const SceneBuffers buffers(device, scene);
    const Buffer cameraBuffer = uploadBuffer(device, std::as_bytes(std::span(&camera, 1)),
                                             vk::BufferUsageFlagBits::eUniformBuffer, "camera");
    const auto storage = [&](const auto& contents, const char* name) {
        return uploadBuffer(device, std::as_bytes(std::span(contents)),
                            vk::BufferUsageFlagBits::eStorageBuffer, name);
    };
    const Buffer rayListBuffer = storage(std::span(&rayList, 1), "parameters of a ray list");
    const Buffer countersBuffer = storage(std::span(&counters, 1), "counters");
    const Buffer recordsBuffer = storage(records, "first hits");
    const Buffer parkedBuffer = storage(parked, "parked tasks");
    const Buffer raysBuffer = storage(rays, "rays");
    const Buffer hitsBuffer = storage(hits, "hits");
    const Buffer echo(device, distinct.words().size() * sizeof(uint32_t),
                      vk::BufferUsageFlagBits::eStorageBuffer, Buffer::Memory::Host, "echo");
    std::vector<Binding> bindings = buffers.bindings();
    bindings.push_back(Binding::uniformBuffer(shared::kBindingCamera, cameraBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingCounters, countersBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingFirstHits, recordsBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingParkedTasks, parkedBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingRays, raysBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingListedHits, hitsBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingTestInputs, rayListBuffer));
    bindings.push_back(Binding::storageBuffer(shared::kBindingTestOutputs, echo));
    const ComputePipeline pipeline(device, {.name = "layout echo",
                                            .spirv = kLayoutEchoSpirv,
                                            .bindings = bindings,
                                            .constants = {},
                                            .pushConstantBytes = sizeof(parameters)});
    pipeline.run(device, 1, std::as_bytes(std::span(&parameters, 1)));

    const std::span<uint32_t> words = echo.mapped<uint32_t>();
    EXPECT_EQ(std::vector<uint32_t>(words.begin(), words.end()), distinct.words());
}

} // namespace
} // namespace calotype::test
