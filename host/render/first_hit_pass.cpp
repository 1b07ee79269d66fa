#include "render/first_hit_pass.h"

#include <algorithm>
#include <chrono>

#include "base/check.h"
#include "base/stopwatch.h"
#include "kernels/first_hit.spv.h"
#include "render/dispatch_sizer.h"
#include "render/loop_budget.h"
#include "render/tiles.h"
#include "shared/bindings.h"
#include "shared/layers.h"

namespace calotype {
namespace {

/// 16 MiB of records: far below any device's limit on a storage buffer.
constexpr uint32_t kMostTilesPerDispatch = 4096;

size_t recordBytes(uint32_t tiles) {
    return size_t{tiles} * kPixelsPerTile * sizeof(shared::FirstHitRecord);
}

/// The kernel computes texture coordinates for every hit, but has them only if there are textures.
/// A scene without textures reads none, so the kind does not matter.
std::vector<vk::Bool32> constantsFor(const SceneFeatures& features) {
    std::vector<vk::Bool32> constants(features.enabled.begin(), features.enabled.end());
    constants[shared::kFeatureColorTextures] = VK_TRUE;
    return constants;
}

std::vector<Binding> withKernelBindings(std::vector<Binding> bindings, const Buffer& camera,
                                        const Buffer& records) {
    bindings.push_back(Binding::uniformBuffer(shared::kBindingCamera, camera));
    bindings.push_back(Binding::storageBuffer(shared::kBindingFirstHits, records));
    return bindings;
}

} // namespace

FirstHitPass::FirstHitPass(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                           const SceneFeatures& features, const RenderSettings& settings)
    : device_(device), origin_(scene.origin), tilesPerRow_(tilesAlong(settings.crop.width)),
      tileCount_(countTiles(settings.crop)),
      tilesPerDispatch_(std::min(tileCount_, kMostTilesPerDispatch)),
      parameters_{.imageSize = {settings.width, settings.height},
                  .cropOrigin = {settings.crop.x, settings.crop.y},
                  .cropSize = {settings.crop.width, settings.crop.height},
                  .firstTile = 0,
                  .iterationsBeforeCut = loopBudget(device)},
      camera_(uploadBuffer(device, std::as_bytes(std::span(&scene.camera, 1)),
                           vk::BufferUsageFlagBits::eUniformBuffer, "camera of the first hits")),
      records_(device, recordBytes(tilesPerDispatch_), vk::BufferUsageFlagBits::eStorageBuffer,
               Buffer::Memory::Host, "first hits"),
      pipeline_(device, {.name = "first hit",
                         .spirv = kFirstHitSpirv,
                         .bindings = withKernelBindings(buffers.bindings(), camera_, records_),
                         .constants = constantsFor(features),
                         .pushConstantBytes = sizeof(shared::FirstHitParameters)}) {
    CALOTYPE_CHECK_EQ(scene.triangleUvs.size(), scene.triangles.size());
}

FirstHitImage FirstHitPass::run(const std::function<void(double)>& onProgress) {
    using Clock = std::chrono::steady_clock;
    FirstHitImage image(parameters_.cropSize.x, parameters_.cropSize.y);
    DispatchSizer sizer(tilesPerDispatch_);
    cutPixels_ = 0;
    for (uint32_t first = 0; first < tileCount_;) {
        const uint32_t count = std::min(sizer.tiles(), tileCount_ - first);
        const Clock::time_point start = Clock::now();
        parameters_.firstTile = first;
        pipeline_.run(device_, count, std::as_bytes(std::span(&parameters_, 1)));
        sizer.update(count, secondsSince(start));
        readTiles(first, count, image);
        first += count;
        if (onProgress)
            onProgress(static_cast<double>(first) / tileCount_);
    }
    return image;
}

void FirstHitPass::readTiles(uint32_t first, uint32_t count, FirstHitImage& image) {
    const std::span<const shared::FirstHitRecord> records =
        records_.mapped<shared::FirstHitRecord>();
    for (uint32_t tile = 0; tile < count; ++tile) {
        const uint32_t left = shared::kTileSize * ((first + tile) % tilesPerRow_);
        const uint32_t top = shared::kTileSize * ((first + tile) / tilesPerRow_);
        const uint32_t right = std::min(left + shared::kTileSize, image.width);
        const uint32_t bottom = std::min(top + shared::kTileSize, image.height);
        for (uint32_t y = top; y < bottom; ++y)
            for (uint32_t x = left; x < right; ++x) {
                const uint32_t inTile = shared::kTileSize * (y - top) + (x - left);
                const shared::FirstHitRecord& record = records[kPixelsPerTile * tile + inTile];
                image.at(x, y) = toFirstHit(record);
                cutPixels_ += record.isCut;
            }
    }
}

FirstHit FirstHitPass::toFirstHit(const shared::FirstHitRecord& record) const {
    static_assert(kNoPrimitive == shared::kNone);
    FirstHit hit = record.hit;
    if (hit.primitive == kNoPrimitive)
        return {};
    hit.position = glm::vec3(glm::dvec3(hit.position) + origin_);
    return hit;
}

uint64_t firstHitPassBytes(const RenderSettings& settings) {
    return recordBytes(std::min(countTiles(settings.crop), kMostTilesPerDispatch)) +
           sizeof(shared::Camera);
}

} // namespace calotype
