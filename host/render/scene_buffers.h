#pragma once

#include <vector>

#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "pack/gpu_scene.h"

namespace calotype {

/// A packed scene on the device. Throws GpuError where it does not fit.
class SceneBuffers {
public:
    SceneBuffers(const Device& device, const GpuScene& scene);

    /// For the kernels that include buffers/packed_scene.glsl.
    std::vector<Binding> bindings() const;

private:
    TexelBuffer nodes_;
    TexelBuffer triangles_;
    TexelBuffer triangleNormals_;
    TexelBuffer triangleUvs_;
    TexelBuffer quadrics_;
    TexelBuffer materials_;
    TexelBuffer textures_;
    TexelBuffer texelRows_;
    TexelBuffer lights_;
    TexelBuffer filterQuantiles_;
};

} // namespace calotype
