#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gpu/compute_pipeline.h"
#include "gpu/storage_image.h"
#include "pack/gpu_scene.h"
#include "render/block_tracer.h"
#include "render/kernel_tuning.h"
#include "render/scene_buffers.h"
#include "settings/render_settings.h"
#include "shared/render_structs.h"

namespace calotype {

/// The path tracing kernel with its storage image, which holds one block of samples.
class PathTracer : public BlockTracer {
public:
    /// Compiles the kernel, specialised for `features`, and for the kind of device unless a tuning
    /// is given. The scene's buffers must outlive this.
    PathTracer(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
               const SceneFeatures& features, const RenderSettings& settings,
               const std::optional<KernelTuning>& tuning = std::nullopt);

    uint32_t tileCount() const override { return static_cast<uint32_t>(tiles_.size()); }
    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut = {}) override;
    /// One dispatch: it goes as far as the device's loop budget allows.
    shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override;
    std::span<const glm::vec4> readBlock() override;

private:
    /// Lists the tiles that have pixels which are not left out.
    void listTiles(std::span<const uint8_t> isLeftOut);

    const Device& device_;
    Crop crop_;
    std::vector<uint32_t> tiles_; ///< of the block, in the order in which they are taken
    shared::RenderParameters parameters_{};
    StorageImage block_;
    Buffer pixels_;   ///< on their way to the block or from it
    Buffer tileList_; ///< tiles_, for the kernel
    Buffer camera_;
    Buffer counters_;
    Buffer parkedTasks_;
    bool isUnfinished_ = false; ///< the last dispatch: there are parked paths
    ComputePipeline pipeline_;
};

/// Bytes that a PathTracer takes on the device, beside the scene.
uint64_t pathTracerBytes(const Device& device, const RenderSettings& settings);

} // namespace calotype
