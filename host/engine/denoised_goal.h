#pragma once

#include <chrono>
#include <exception>
#include <optional>

#include "engine/picture_denoiser.h"
#include "film/film.h"
#include "image/denoiser_features.h"

namespace calotype {

/// Denoises a film from time to time while it is rendered, to end the render when the picture after
/// denoising is good enough.
class DenoisedGoal {
public:
    /// Keeps references. `threads` 0: all cores.
    DenoisedGoal(double targetError, const PictureDenoiser& denoiser,
                 const std::optional<DenoiserFeatures>& features, uint32_t threads)
        : targetError_(targetError), denoiser_(denoiser), features_(features), threads_(threads) {}

    /// The error of the film after denoising. None where it is most likely above the target, until
    /// as much time has passed as denoising took before, where nobody can state the error, or if
    /// denoising fails: then the render should end. `onProgress` as for PictureDenoiser::run; it
    /// may throw Interrupted to end the work.
    std::optional<DenoisedError> errorOf(const Film& film,
                                         const PictureDenoiser::OnProgress& onProgress);

    /// The picture of the last errorOf, if the film had as many samples as now.
    std::optional<CleanPicture> take(const Film& film);

    /// Why denoising failed; null if it did not.
    std::exception_ptr failure() const { return failure_; }

    double seconds() const { return seconds_; } ///< of denoising, all together

private:
    using Clock = std::chrono::steady_clock;

    /// Errors fall with the root of the samples, or slower.
    bool isDue(uint64_t samples) const;

    double targetError_;
    const PictureDenoiser& denoiser_;
    const std::optional<DenoiserFeatures>& features_;
    uint32_t threads_;
    std::optional<CleanPicture> picture_;
    std::exception_ptr failure_;
    uint64_t samples_ = 0; ///< per pixel, of `picture_`
    double seconds_ = 0.0;
    double lastSeconds_ = 0.0; ///< of denoising `picture_`
    Clock::time_point lastEnd_;
};

} // namespace calotype
