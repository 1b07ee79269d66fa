#pragma once

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "pack/gpu_scene.h"

namespace calotype {

/// A packed scene on the device. The constructor throws GpuError if it does not fit.
class SceneBuffers {
public:
    SceneBuffers(const Device& device, const GpuScene& scene);

    /// The bindings for kernels that include buffers/packed_scene.glsl.
    std::vector<Binding> bindings() const;

private:
    struct BoundBuffer {
        uint32_t binding;
        TexelBuffer rows;
    };
    std::vector<BoundBuffer> buffers_; ///< as in shared/binding_table.h
};

} // namespace calotype
