#pragma once

#include <chrono>
#include <cstdint>
#include <optional>

#include "base/stopwatch.h"
#include "film/error_estimate.h"
#include "render/session.h"

namespace calotype {

/// Keeps the error of a growing film up to date in a small share of the time.
class ErrorWatch {
public:
    /// Sets `error` to that of the film, if the film has new samples. `samples` is the film's
    /// number of samples, of all pixels together or of each.
    template <typename AnyFilm>
    void update(const AnyFilm& film, uint64_t samples, std::optional<ErrorEstimate>& error) {
        if (samplesJudged_ == samples)
            return;
        const auto before = std::chrono::steady_clock::now();
        error = estimateError(film);
        samplesJudged_ = samples;
        seconds_ = secondsSince(before);
        last_ = std::chrono::steady_clock::now();
    }

    /// Whether a new estimate stays within its share of the time.
    bool isDue() const { return samplesJudged_ == 0 || kShare * secondsSince(last_) >= seconds_; }

private:
    static constexpr double kShare = 0.02;

    uint64_t samplesJudged_ = 0;
    double seconds_ = 0.0;
    std::chrono::steady_clock::time_point last_;
};

/// Whether the error is small enough and trusted.
inline bool isReached(const RenderGoal& goal, const std::optional<ErrorEstimate>& error) {
    return goal.targetError && error && error->isTrusted() &&
           error->upperBound() <= *goal.targetError;
}

/// Likewise by the error after denoising, which `totals` take over. Needs a goal with
/// denoisedError.
inline bool isReachedDenoised(const RenderGoal& goal, const FilmView& film, RenderTotals& totals) {
    const std::optional<DenoisedError> error = goal.denoisedError(film);
    if (!error)
        return false;
    totals.denoised = error;
    totals.denoisedSamples = film.samplesPerPixel();
    return error->upperBound <= *goal.targetError;
}

} // namespace calotype
