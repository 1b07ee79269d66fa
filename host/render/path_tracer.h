#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "gpu/compute_pipeline.h"
#include "gpu/storage_image.h"
#include "pack/gpu_scene.h"
#include "render/render_settings.h"
#include "render/scene_buffers.h"
#include "shared/render_structs.h"

namespace calotype {

/// The path tracing kernel with its storage image, which holds one block of samples.
class PathTracer {
public:
    /// A range of the picture's tiles, in the order in which they are spread over the threads.
    struct TileRange {
        uint32_t first = 0;
        uint32_t count = 0;
    };

    /// Compiles the kernel, specialised for `features`. The scene's buffers must outlive this.
    PathTracer(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
               const SceneFeatures& features, const RenderSettings& settings);

    uint32_t tileCount() const { return tileCount_; }

    /// Empties the storage image for the block that begins at the absolute sample `firstSample`.
    void beginBlock(uint32_t firstSample);

    /// Brings the pixels of some tiles to `sampleEnd` samples of the block, as far as the loop
    /// budget of one dispatch allows: call again while `unfinishedPixels` is not zero.
    gpu::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd);

    /// The block so far: per pixel the sum of r, g, b, and in w the number of samples. Valid until
    /// the next call.
    std::span<const glm::vec4> readBlock();

private:
    const Device& device_;
    uint32_t tileCount_;
    gpu::RenderParameters parameters_{};
    StorageImage block_;
    Buffer readback_;
    Buffer camera_;
    Buffer counters_;
    ComputePipeline pipeline_;
};

/// Bytes that a PathTracer takes on the device, beside the scene.
uint64_t pathTracerBytes(const RenderSettings& settings);

} // namespace calotype
