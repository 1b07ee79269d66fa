#pragma once

#include <cstdint>
#include <functional>

#include "image/features.h"
#include "render/feature_rays.h"
#include "render/record_pass.h"
#include "shared/layers.h"

namespace calotype {

/// The kernel that finds the features of each pixel (shaders/path/features.glsl).
class FeaturePass {
public:
    /// Compiles the kernel, specialised for `features` of the scene and the sampler of the
    /// settings, of which only the film's size, the crop, the seed and the sampler matter. The
    /// scene's buffers must outlive this object.
    FeaturePass(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                const SceneFeatures& features, const RenderSettings& settings);

    /// The means of `rays` > 0 rays. `onProgress`, if given, is called about ten times a second
    /// with the share done in [0, 1]; it may throw to end the work.
    FeatureImage run(uint32_t rays, const std::function<void(double)>& onProgress = {},
                     const OnPrimitives& onPrimitives = {});

    /// Rays of the last run that a limit ended at a surface where they would go on.
    uint64_t cutRays() const { return cutRays_; }

private:
    shared::RecordParameters parameters_;
    RecordPass<shared::FeatureRecord> pass_;
    uint64_t cutRays_ = 0;
};

/// Bytes that a FeaturePass needs on the device, in addition to the scene.
uint64_t featurePassBytes(const RenderSettings& settings);

} // namespace calotype
