#include "render/path_tracer.h"

#include <algorithm>

#include "base/check.h"
#include "kernels/parked_task.h"
#include "kernels/path_trace.spv.h"
#include "render/loop_budget.h"
#include "render/specialization.h"
#include "render/tiles.h"
#include "shared/bindings.h"

namespace calotype {
namespace {

shared::RenderParameters makeParameters(const GpuScene& scene, const RenderSettings& settings,
                                        uint32_t iterationBudget) {
    shared::RenderParameters parameters{};
    parameters.imageSize = {settings.width, settings.height};
    parameters.cropOrigin = {settings.crop.x, settings.crop.y};
    parameters.cropSize = {settings.crop.width, settings.crop.height};
    parameters.seed = settings.seed;
    parameters.maxBounces = settings.maxBounces;
    parameters.lightCount = scene.lightCount;
    parameters.infiniteLight = scene.infiniteLight;
    parameters.lightTreeDepth = scene.lightTreeDepth;
    parameters.iterationBudget = iterationBudget;
    parameters.indirectClamp = settings.transport.indirectClamp;
    return parameters;
}

std::vector<Binding> withKernelBindings(std::vector<Binding> bindings, const Buffer& camera,
                                        const StorageImage& block, const Buffer& counters,
                                        const Buffer& parkedTasks, const Buffer& tileList) {
    bindings.push_back(Binding::uniformBuffer(shared::kBindingCamera, camera));
    bindings.push_back(Binding::storageImage(shared::kBindingBlock, block));
    bindings.push_back(Binding::storageBuffer(shared::kBindingCounters, counters));
    bindings.push_back(Binding::storageBuffer(shared::kBindingParkedTasks, parkedTasks));
    bindings.push_back(Binding::storageBuffer(shared::kBindingTiles, tileList));
    return bindings;
}

size_t parkedBytes(const Device& device, const Crop& crop) {
    return size_t{std::min(countTiles(crop), shared::kMostTilesPerDispatch)} *
           device.info().subgroupSize * shared::kTasksPerLane * sizeof(shared::ParkedTask);
}

size_t tileListBytes(const Crop& crop) { return countTiles(crop) * sizeof(uint32_t); }

size_t blockBytes(const Crop& crop) { return size_t{crop.width} * crop.height * sizeof(glm::vec4); }

} // namespace

PathTracer::PathTracer(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                       const SceneFeatures& features, const RenderSettings& settings,
                       const std::optional<KernelTuning>& tuning)
    : device_(device), crop_(settings.crop),
      parameters_(makeParameters(scene, settings, loopBudget(device))),
      block_(device, settings.crop.width, settings.crop.height, "block"),
      pixels_(device, blockBytes(settings.crop),
              vk::BufferUsageFlagBits::eTransferSrc | vk::BufferUsageFlagBits::eTransferDst,
              Buffer::Memory::Host, "block on its way"),
      tileList_(device, tileListBytes(settings.crop),
                vk::BufferUsageFlagBits::eStorageBuffer | vk::BufferUsageFlagBits::eTransferDst,
                Buffer::Memory::Device, "tiles"),
      camera_(uploadBuffer(device, std::as_bytes(std::span(&scene.camera, 1)),
                           vk::BufferUsageFlagBits::eUniformBuffer, "camera")),
      counters_(device, sizeof(shared::RenderCounters), vk::BufferUsageFlagBits::eStorageBuffer,
                Buffer::Memory::Host, "counters"),
      parkedTasks_(zeroedBuffer(device, parkedBytes(device, settings.crop), "parked tasks")),
      pipeline_(device, {.name = "path trace",
                         .spirv = kPathTraceSpirv,
                         .bindings = withKernelBindings(buffers.bindings(), camera_, block_,
                                                        counters_, parkedTasks_, tileList_),
                         .constants = specialization(device, features, tuning, settings.sampler,
                                                     settings.transport),
                         .pushConstantBytes = sizeof(shared::RenderParameters)}) {
    // Some drivers compile at the first dispatch: this one has no samples.
    beginBlock(0);
    renderTiles({0, 1}, 0);
}

void PathTracer::beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) {
    parameters_.firstSample = firstSample;
    if (isLeftOut.empty()) {
        block_.clear(device_);
    } else { // as if they had all of their samples
        std::ranges::transform(isLeftOut, pixels_.mapped<glm::vec4>().begin(), [](uint8_t isOut) {
            return glm::vec4(0.0f, 0.0f, 0.0f, isOut != 0 ? float{shared::kSamplesPerBlock} : 0.0f);
        });
        block_.copyFrom(device_, pixels_.handle());
    }
    if (isUnfinished_)
        clear(device_, parkedTasks_);
    isUnfinished_ = false;
    if (!isLeftOut.empty() || tiles_.size() != countTiles(crop_))
        listTiles(isLeftOut);
}

void PathTracer::listTiles(std::span<const uint8_t> isLeftOut) {
    const uint32_t count = countTiles(crop_);
    std::vector<uint8_t> hasPixels(count, isLeftOut.empty() ? 1 : 0);
    for (size_t i = 0; i < isLeftOut.size(); ++i)
        if (isLeftOut[i] == 0) {
            const auto x = static_cast<uint32_t>(i % crop_.width);
            const auto y = static_cast<uint32_t>(i / crop_.width);
            hasPixels[y / shared::kTileSize * tilesAlong(crop_.width) + x / shared::kTileSize] = 1;
        }
    const uint32_t stride = coprimeStride(count);
    tiles_.clear();
    for (uint32_t i = 0; i < count; ++i)
        if (const uint32_t tile = i * stride % count; hasPixels[tile] != 0)
            tiles_.push_back(tile);
    overwrite(device_, std::as_bytes(std::span(tiles_)), tileList_);
}

shared::RenderCounters PathTracer::renderTiles(TileRange tiles, uint32_t sampleEnd) {
    CALOTYPE_CHECK_LE(tiles.count, shared::kMostTilesPerDispatch);
    CALOTYPE_CHECK_LE(tiles.first + tiles.count, tileCount());
    parameters_.firstTile = tiles.first;
    parameters_.sampleEnd = sampleEnd;
    shared::RenderCounters& counters = counters_.mapped<shared::RenderCounters>()[0];
    counters = {};
    pipeline_.run(device_, tiles.count, std::as_bytes(std::span(&parameters_, 1)));
    isUnfinished_ = counters.unfinishedPixels > 0;
    return counters;
}

std::span<const glm::vec4> PathTracer::readBlock() {
    block_.copyTo(device_, pixels_.handle());
    return pixels_.mapped<glm::vec4>();
}

uint64_t pathTracerBytes(const Device& device, const RenderSettings& settings) {
    return 2 * blockBytes(settings.crop) + sizeof(shared::Camera) + sizeof(shared::RenderCounters) +
           parkedBytes(device, settings.crop) + tileListBytes(settings.crop);
}

} // namespace calotype
