#pragma once

#include <cstdint>
#include <optional>

#include "denoise/denoised_error.h"
#include "film/error_estimate.h"
#include "film/film_losses.h"

namespace calotype {

/// Sums over a session so far.
struct RenderTotals {
    uint64_t rays = 0;
    uint64_t paths = 0;
    FilmLosses losses;                  ///< of the picture, also those of earlier renders
    uint64_t samplesPerPixel = 0;       ///< of every pixel; with adaptive sampling the mean
    double seconds = 0.0;               ///< of sampling alone
    double firstSampleSeconds = 0.0;    ///< of sampling until every pixel had a sample
    std::optional<ErrorEstimate> error; ///< of the film's whole blocks, updated from time to time
    /// With RenderGoal::denoisedError: what it was last, and the samples per pixel of that picture.
    std::optional<DenoisedError> denoised;
    uint64_t denoisedSamples = 0;
};

/// Why a render ended.
enum class RenderEnding : uint8_t { AllSamples, TargetError, Deadline, Stopped };

} // namespace calotype
