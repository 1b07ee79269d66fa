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

/// Which rays of a picture's paths: one a pixel at most.
struct RayKind {
    bool isShadow = false; ///< to a light, from what the camera sees
    uint32_t bounces = 0;  ///< else: after so many scattering events

    static RayKind shadow() { return {true, 0}; }
    static RayKind afterBounces(uint32_t bounces) { return {false, bounces}; }
};

/// Those of the picture's first sample that are of a kind, tile by tile; pixels whose path has no
/// such ray are left out.
std::vector<shared::ListedRay> listRays(const Device& device, const GpuScene& scene,
                                        const SceneBuffers& buffers, const RenderSettings& settings,
                                        RayKind kind);

/// A list of rays on the device, for the traversal alone. Shadow rays look for any hit, others for
/// the closest.
class RayListTracer {
public:
    /// `rays` must not be empty; the scene's buffers must outlive this.
    RayListTracer(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                  std::span<const shared::ListedRay> rays, RayKind kind);

    /// Traces all rays; returns the seconds it took.
    double trace();

    /// What the rays met, in their order; valid until the next call of `trace`.
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
