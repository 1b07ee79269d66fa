#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "base/stopwatch.h"
#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "pack/gpu_scene.h"
#include "render/dispatch_sizer.h"
#include "render/loop_budget.h"
#include "render/scene_buffers.h"
#include "render/tiles.h"
#include "settings/crop.h"
#include "settings/render_settings.h"
#include "shared/bindings.h"
#include "shared/limits.h"
#include "shared/render_structs.h"

namespace calotype {

/// A kernel that traces a ray of each pixel, and writes a Record for it. Its push constants are
/// shared::RecordParameters. Within a tile, records are row by row.
template <typename Record>
class RecordPass {
public:
    /// 16 MiB of records and more: far below any device's limit on a storage buffer.
    static constexpr uint32_t kMostTilesPerDispatch = 4096;

    struct Kernel {
        const char* name;
        std::span<const uint32_t> spirv;
        uint32_t binding;                ///< of the records
        std::vector<uint32_t> constants; ///< of specialization
    };

    /// Compiles the kernel. The scene's buffers must outlive this object.
    RecordPass(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
               const Crop& crop, const Kernel& kernel)
        : device_(device), crop_(crop), tileCount_(countTiles(crop)),
          sizer_(std::min(tileCount_, kMostTilesPerDispatch)),
          camera_(uploadBuffer(device, std::as_bytes(std::span(&scene.camera, 1)),
                               vk::BufferUsageFlagBits::eUniformBuffer,
                               std::string("camera of ") + kernel.name)),
          records_(device, bytes(crop), vk::BufferUsageFlagBits::eStorageBuffer,
                   Buffer::Memory::Host, std::string("records of ") + kernel.name),
          pipeline_(device, {.name = kernel.name,
                             .spirv = kernel.spirv,
                             .bindings = bindings(buffers, kernel.binding),
                             .constants = kernel.constants,
                             .pushConstantBytes = sizeof(shared::RecordParameters)}) {}

    /// Calls take(x, y, record) for each pixel of the crop, counted from its top left corner.
    /// `onProgress`, if given, is called about ten times a second with the share done in [0, 1]; it
    /// may throw to end the work.
    template <typename Take>
    void run(shared::RecordParameters parameters, const Take& take,
             const std::function<void(double)>& onProgress) {
        for (uint32_t first = 0; first < tileCount_;) {
            const uint32_t count = std::min(sizer_.tiles(), tileCount_ - first);
            const auto start = std::chrono::steady_clock::now();
            parameters.firstTile = first;
            pipeline_.run(device_, count, std::as_bytes(std::span(&parameters, 1)));
            sizer_.update(count, secondsSince(start));
            readTiles(first, count, take);
            first += count;
            if (onProgress)
                onProgress(static_cast<double>(first) / tileCount_);
        }
    }

    /// Bytes that the pass needs on the device, in addition to the scene.
    static uint64_t deviceBytes(const Crop& crop) { return bytes(crop) + sizeof(shared::Camera); }

private:
    static size_t bytes(const Crop& crop) {
        return size_t{std::min(countTiles(crop), kMostTilesPerDispatch)} * kPixelsPerTile *
               sizeof(Record);
    }

    std::vector<Binding> bindings(const SceneBuffers& buffers, uint32_t records) const {
        std::vector<Binding> bindings = buffers.bindings();
        bindings.push_back(Binding::uniformBuffer(shared::kBindingCamera, camera_));
        bindings.push_back(Binding::storageBuffer(records, records_));
        return bindings;
    }

    template <typename Take>
    void readTiles(uint32_t first, uint32_t count, const Take& take) {
        const std::span<const Record> records = records_.template mapped<Record>();
        const uint32_t tilesPerRow = tilesAlong(crop_.width);
        for (uint32_t tile = 0; tile < count; ++tile) {
            const uint32_t left = shared::kTileSize * ((first + tile) % tilesPerRow);
            const uint32_t top = shared::kTileSize * ((first + tile) / tilesPerRow);
            const uint32_t right = std::min(left + shared::kTileSize, crop_.width);
            const uint32_t bottom = std::min(top + shared::kTileSize, crop_.height);
            for (uint32_t y = top; y < bottom; ++y)
                for (uint32_t x = left; x < right; ++x)
                    take(x, y,
                         records[kPixelsPerTile * tile + shared::kTileSize * (y - top) +
                                 (x - left)]);
        }
    }

    const Device& device_;
    Crop crop_;
    uint32_t tileCount_;
    DispatchSizer sizer_;
    Buffer camera_;
    Buffer records_;
    ComputePipeline pipeline_;
};

/// What all such kernels need.
inline shared::RecordParameters recordParameters(const Device& device,
                                                 const RenderSettings& settings) {
    shared::RecordParameters parameters{};
    parameters.imageSize = {settings.width, settings.height};
    parameters.cropOrigin = {settings.crop.x, settings.crop.y};
    parameters.cropSize = {settings.crop.width, settings.crop.height};
    parameters.iterationsBeforeCut = loopBudget(device);
    return parameters;
}

} // namespace calotype
