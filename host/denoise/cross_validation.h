#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "denoise/denoised_error.h"
#include "denoise/denoiser.h"
#include "image/image.h"

namespace calotype {

/// One of several pictures of the same scene and camera, from independent samples. The replicas of
/// a group have nearly the same number of samples in a pixel; other pixels, and other groups, may
/// have others. The mean of all replicas is that of the groups' means, each weighted by the number
/// of its replicas; within a group by the samples.
struct ReplicaPicture {
    Image mean;                    ///< radiance, W/(m^2 sr)
    std::vector<uint32_t> samples; ///< of each pixel, > 0; or one number for all pixels
    uint32_t group = 0;

    double samplesIn(size_t pixel) const { return samples[samples.size() > 1 ? pixel : 0]; }
};

struct DenoisedPicture {
    Image color;
    std::optional<DenoisedError> error; ///< none unless canStateError
};

/// Whether the error of a picture of this size can be stated: it has at least 8 tiles.
bool canStateError(uint32_t width, uint32_t height);

/// The number of replicas of a group that denoise needs: the variance of a replica is taken from at
/// least two others of its group.
inline constexpr size_t kLeastReplicas = 3;

/// Denoises the mean of the replicas, and states its error by cross-validation (docs/models.md,
/// "Denoising"): each replica judges a picture that was denoised without it. Where the samples are
/// better than the denoiser, they have the greater weight, so that more samples end at the truth.
/// Runs the denoiser once, and once for each replica. `threads` 0: all cores; the result does not
/// depend on it. `onProgress` is called after each run, and while the error is found, with the
/// share done in [0, 1]; it may throw to end the work.
DenoisedPicture denoise(std::span<const ReplicaPicture> replicas, Denoiser& denoiser,
                        uint32_t threads = 0, const std::function<void(double)>& onProgress = {});

} // namespace calotype
