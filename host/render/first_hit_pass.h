#pragma once

#include <cstdint>
#include <functional>

#include "image/first_hit.h"
#include "render/record_pass.h"
#include "shared/layers.h"

namespace calotype {

/// The kernel that finds what each pixel shows first (shaders/path/first_hit.glsl).
class FirstHitPass {
public:
    /// Compiles the kernel, specialised for `features`. The scene must be packed with
    /// PackOptions::allUvs; its buffers must outlive this object. Of the settings only the film's
    /// size and the crop matter.
    FirstHitPass(const Device& device, const GpuScene& scene, const SceneBuffers& buffers,
                 const SceneFeatures& features, const RenderSettings& settings);

    /// Returns the first hits of the crop. `onProgress`, if given, is called about ten times a
    /// second with the share done in [0, 1]; it may throw to end the work.
    FirstHitImage run(const std::function<void(double)>& onProgress = {});

    /// Pixels of the last run whose rays hit more transparent surfaces than the kernel passes
    /// through: they show the next surface as if it were opaque.
    uint64_t cutPixels() const { return cutPixels_; }

private:
    FirstHit toFirstHit(const shared::FirstHitRecord& record) const;

    glm::dvec3 origin_;
    shared::RecordParameters parameters_;
    RecordPass<shared::FirstHitRecord> pass_;
    uint64_t cutPixels_ = 0;
};

/// Bytes that a FirstHitPass needs on the device, in addition to the scene.
uint64_t firstHitPassBytes(const RenderSettings& settings);

} // namespace calotype
