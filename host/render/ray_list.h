#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gpu/compute_pipeline.h"
#include "pack/gpu_scene.h"
#include "render/dispatch_sizer.h"
#include "render/scene_buffers.h"
#include "settings/render_settings.h"
#include "shared/ray_structs.h"

namespace calotype {

/// A kind of ray of a picture's paths: at most one per pixel.
struct RayKind {
    bool isShadow = false; ///< to a light, from the first hit
    uint32_t bounces = 0;  ///< for other rays: scattering events before the ray

    static RayKind shadow() { return {true, 0}; }
    static RayKind afterBounces(uint32_t bounces) { return {false, bounces}; }
};

/// The rays of one kind of the picture's first sample, tile by tile. Pixels whose path has no such
/// ray are left out.
std::vector<shared::ListedRay> listRays(const Device& device, const GpuScene& scene,
                                        const SceneBuffers& buffers, const RenderSettings& settings,
                                        RayKind kind);

/// A list of rays on the device, to measure the traversal alone. Shadow rays search any hit, other
/// rays the closest.
class RayListTracer {
public:
    /// `rays` must not be empty; the scene's buffers must outlive this object.
    RayListTracer(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                  std::span<const shared::ListedRay> rays, RayKind kind);

    /// Traces all rays. Returns the seconds that this took.
    double trace();

    /// The hits of the rays, in their order; valid until the next call of `trace`.
    std::span<const shared::ListedHit> hits() const { return hits_.mapped<shared::ListedHit>(); }

private:
    const Device& device_;
    DispatchSizer sizer_;
    shared::RayListParameters parameters_{};
    Buffer rays_;
    Buffer hits_;
    ComputePipeline pipeline_;
};

} // namespace calotype
