#pragma once

#include <optional>

#include "pack/gpu_scene.h"
#include "render/path_tracer.h"
#include "render/scene_buffers.h"
#include "scene/scene.h"

namespace calotype::test {

/// For a square picture of a scene, `side` pixels wide, with the scene's own bounces and choice of
/// lights.
RenderSettings squareSettings(const Scene& scene, uint32_t side, uint32_t seed);

/// A scene packed for the test device, with the kernel that renders it.
class DeviceTracer {
public:
    /// `features` are those that the scene needs, and the tuning that of the device, unless given.
    DeviceTracer(const Scene& scene, const RenderSettings& settings,
                 const std::optional<SceneFeatures>& features = std::nullopt,
                 const std::optional<KernelTuning>& tuning = std::nullopt);

    PathTracer& tracer() { return tracer_; }
    const GpuScene& packed() const { return packed_; }

private:
    GpuScene packed_;
    SceneBuffers buffers_;
    PathTracer tracer_;
};

} // namespace calotype::test
