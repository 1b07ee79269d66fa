#pragma once

#include <cstdint>
#include <string>

#include "extremes/kernels/edge_ray_structs.h"
#include "gpu/compute_pipeline.h"
#include "pack/gpu_scene.h"
#include "render/scene_buffers.h"

namespace calotype::test {

/// A closed mesh on the device, for rays from inside that are aimed at its corners and edges.
class EdgeRayScene {
public:
    /// `UnitLength` as the renderer's rays; `ToTheAim` meets corners and edges more exactly.
    enum class Directions : uint8_t { ToTheAim, UnitLength };

    /// All of the surface is seen from `center`, which is given in the world; rays start up to nine
    /// tenths of the way from there to the surface.
    EdgeRayScene(const GpuScene& packed, const glm::dvec3& center,
                 Directions directions = Directions::ToTheAim);

    struct Escapes {
        uint64_t rays = 0;
        uint64_t count = 0;
        uint32_t mostIterations = 0; ///< of one invocation
        std::string last;            ///< origin and direction of one of them
    };

    /// Casts `rays` rays or a few more, in dispatches of a million at most.
    Escapes cast(uint64_t rays) const;

private:
    void addDispatch(uint32_t seed, Escapes& escapes) const;

    shared::EdgeBatch batch_{};
    SceneBuffers sceneBuffers_;
    Buffer batches_;
    Buffer escapes_;
    ComputePipeline pipeline_;
};

} // namespace calotype::test
