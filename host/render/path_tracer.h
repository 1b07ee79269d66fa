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
    /// Compiles the kernel, specialised for `features` and, unless a tuning is given, for the kind
    /// of device. The scene's buffers must outlive this object.
    PathTracer(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
               const SceneFeatures& features, const RenderSettings& settings,
               const std::optional<KernelTuning>& tuning = std::nullopt);

    uint32_t tileCount() const override { return static_cast<uint32_t>(tiles_.size()); }
    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut = {}) override;
    /// One dispatch; it stops at the device's loop budget.
    shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override;
    std::span<const glm::vec4> readBlock() override;

private:
    /// Lists the tiles that have pixels to render.
    void listTiles(std::span<const uint8_t> isLeftOut);

    const Device& device_;
    Crop crop_;
    std::vector<uint32_t> tiles_; ///< of the block, in the order of rendering
    shared::RenderParameters parameters_{};
    StorageImage block_;
    Buffer pixels_;   ///< staging for the block
    Buffer tileList_; ///< tiles_, for the kernel
    Buffer camera_;
    Buffer counters_;
    Buffer parkedTasks_;
    bool isUnfinished_ = false; ///< the last dispatch left parked paths
    ComputePipeline pipeline_;
};

/// Bytes that a PathTracer needs on the device, in addition to the scene.
uint64_t pathTracerBytes(const Device& device, const RenderSettings& settings);

} // namespace calotype
