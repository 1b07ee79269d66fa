#pragma once

#include <memory>

#include "engine/compile_scene.h"
#include "engine/device_session.h"
#include "engine/render_engine.h"
#include "pack/gpu_scene.h"
#include "render/path_tracer.h"
#include "render/scene_buffers.h"

namespace calotype {

/// Renders on a Vulkan device.
class DeviceEngine : public RenderEngine {
public:
    /// `scene` is read by this constructor only. Throws GpuError and SceneError.
    DeviceEngine(std::shared_ptr<const DeviceSession> session, const Scene& scene,
                 const EngineRequest& request, StageSeconds& seconds);

    BlockTracer& tracer() override { return tracer_; }
    double maxRadiance() const override { return packed_.maxRadiance; }
    FirstHitImage firstHits(const std::function<void(double)>& onProgress) override;
    FeatureImage features(const std::function<void(double)>& onProgress,
                          const OnPrimitives& onPrimitives) override;
    uint64_t cutPixels() const override { return cutPixels_; }
    uint64_t cutFeatureRays() const override { return cutFeatureRays_; }
    DeviceInfo info() const override { return device().info(); }
    const char* tree() const override { return nameOf(builder_); }
    uint64_t deviceBytes() const override { return deviceBytes_; }
    const Device& device() const { return session_->device(); }
    const GpuScene& packed() const { return packed_; }
    const SceneBuffers& buffers() const { return buffers_; }
    void finish() const override { session_->throwOnValidationMessages(); }

private:
    RenderSettings settings_;
    BvhBuilder builder_ = BvhBuilder::Sah;
    std::shared_ptr<const DeviceSession> session_;
    GpuScene packed_;
    uint64_t deviceBytes_;
    SceneBuffers buffers_;
    PathTracer tracer_;
    uint64_t cutPixels_ = 0;
    uint64_t cutFeatureRays_ = 0;
};

} // namespace calotype
