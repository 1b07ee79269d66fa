#pragma once

#include <cstdint>
#include <string>

#include "denoise/denoiser.h"
#include "image/denoiser_features.h"

namespace calotype {

/// Mixes pixels whose difference may be noise (docs/models.md, "The statistical denoiser"), in
/// double precision on the CPU. The kernel that does the same is tested against it.
class StatisticalDenoiser : public Denoiser {
public:
    /// `threads` 0: all cores.
    StatisticalDenoiser(DenoiserFeatures features, uint32_t threads);

    std::string name() const override { return "statistical"; }

    /// Needs the standard error, of 2 to shared::kReplicas replicas. All numbers must be finite.
    Image run(const NoisyImage& noisy) override;

private:
    DenoiserFeatures features_;
    uint32_t threads_;
};

} // namespace calotype
