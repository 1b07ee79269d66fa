#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "denoise/denoiser.h"
#include "denoise/pixel_statistics.h"
#include "gpu/buffer.h"
#include "gpu/compute_pipeline.h"
#include "image/denoiser_features.h"
#include "render/dispatch_sizer.h"
#include "settings/crop.h"

namespace calotype {

/// The statistical denoiser (docs/models.md, "The statistical denoiser") on a device, in windows of
/// the picture, so that its memory is bounded.
class StatisticalPass : public Denoiser {
public:
    /// The device must outlive this object. `threads` of the host, for what it prepares; 0: all
    /// cores.
    StatisticalPass(const Device& device, DenoiserFeatures features, uint32_t threads);

    std::string name() const override { return "statistical"; }

    /// As StatisticalDenoiser::run.
    Image run(const NoisyImage& noisy) override;

private:
    /// Sets the pixels of `inner` in `image`.
    void denoise(const Crop& inner, const std::vector<PixelStatistics>& statistics,
                 float squaredBound, Image& image);
    TexelBuffer upload(const Crop& window, const std::vector<PixelStatistics>& statistics) const;
    void dispatch(const char* name, std::span<const uint32_t> spirv,
                  const std::vector<Binding>& bindings, const Crop& window, float squaredBound);

    const Device& device_;
    DenoiserFeatures features_;
    uint32_t threads_;
    Buffer sums_;
    Buffer clean_;
    DispatchSizer sizer_;
};

/// Bytes that a StatisticalPass needs on the device for pictures of this size.
uint64_t statisticalPassBytes(uint32_t width, uint32_t height);

} // namespace calotype
