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

/// A scene made ready for a device, with what each step on the way left.
struct CompiledScene {
    std::vector<Primitive> primitives; ///< relative to `packed.origin`
    BvhBuilder builder = BvhBuilder::Sah;
    Bvh bvh;
    GpuScene packed; ///< with the features of the kernel that it needs
};

struct CompileOptions {
    bool allUvs = false; ///< keeps texture coordinates without textures, for layers of first hits
    std::function<void(double)> onProgress; ///< told the share done in [0, 1]; may throw
};

/// Chooses the origin, collects the primitives, builds their tree and packs everything. Throws
/// SceneError where the scene does not fit a device's arithmetic.
CompiledScene compileScene(const Scene& scene, const RenderSettings& settings,
                           const CompileOptions& options = {});

} // namespace calotype
