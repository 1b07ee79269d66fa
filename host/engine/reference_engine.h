#pragma once

#include "engine/render_engine.h"
#include "reference/reference_tracer.h"
#include "render/reference_block.h"

namespace calotype {

/// Renders in double precision on the CPU: slow; devices are tested against it.
class ReferenceEngine : public RenderEngine {
public:
    /// `scene` must outlive this object.
    ReferenceEngine(const DeviceOptions& options, const Scene& scene, const EngineRequest& request,
                    StageSeconds& seconds);

    BlockTracer& tracer() override { return block_; }
    double maxRadiance() const override { return tracer_.maxRadiance(); }
    FirstHitImage firstHits(const std::function<void(double)>& onProgress) override;
    FeatureImage features(const std::function<void(double)>& onProgress,
                          const OnPrimitives& onPrimitives) override;
    DeviceInfo info() const override;
    const char* tree() const override { return "reference"; }

private:
    RenderSettings settings_;
    uint32_t threads_;
    reference::ReferenceTracer tracer_;
    ReferenceBlock block_;
};

} // namespace calotype
