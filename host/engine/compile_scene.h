#pragma once

#include <functional>
#include <vector>

#include <glm/vec3.hpp>

#include "accel/bvh.h"
#include "accel/primitive.h"
#include "pack/gpu_scene.h"
#include "scene/scene.h"
#include "settings/bvh_builder.h"
#include "settings/render_settings.h"

namespace calotype {

/// A scene ready for a device, with the results of all steps.
struct CompiledScene {
    std::vector<Primitive> primitives; ///< relative to `packed.origin`
    BvhBuilder builder = BvhBuilder::Sah;
    Bvh bvh;
    GpuScene packed; ///< with the kernel features that it needs
};

struct CompileOptions {
    bool allUvs = false; ///< keeps texture coordinates without textures, for first-hit layers
    /// Called with the share done in [0, 1]; may throw.
    std::function<void(double)> onProgress = {};
};

/// Chooses the origin, collects the primitives, builds the BVH and packs everything. Throws
/// SceneError if the scene exceeds the range of a device's arithmetic.
CompiledScene compileScene(const Scene& scene, const RenderSettings& settings,
                           const CompileOptions& options = {});

} // namespace calotype
