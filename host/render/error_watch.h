#pragma once

#include <bit>
#include <chrono>
#include <cstdint>
#include <optional>

#include "base/stopwatch.h"
#include "film/error_estimate.h"
#include "render/session.h"
#include "shared/limits.h"

namespace calotype {

/// Keeps the error of a growing film up to date without taking much of the time.
class ErrorWatch {
public:
    /// Sets `error` to the film's, unless it is that already. `samples` are the film's, of all
    /// pixels together or of each.
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

    /// Whether estimating anew keeps to its share of the time.
    bool isDue() const { return samplesJudged_ == 0 || kShare * secondsSince(last_) >= seconds_; }

private:
    static constexpr double kShare = 0.02;

    uint64_t samplesJudged_ = 0;
    double seconds_ = 0.0;
    std::chrono::steady_clock::time_point last_;
};

/// The least samples per pixel that a render may be judged by: one block of every replica.
inline constexpr uint64_t kFirstLook = uint64_t{shared::kReplicas} * shared::kSamplesPerBlock;

/// Whether a goal is looked at when the pixels have this number of samples.
inline bool isLook(uint64_t samplesPerPixel) {
    return samplesPerPixel >= kFirstLook && std::has_single_bit(samplesPerPixel);
}

/// Whether the error is good enough, and to be trusted.
inline bool isReached(const RenderGoal& goal, const std::optional<ErrorEstimate>& error) {
    return goal.targetError && error && error->isTrusted() &&
           error->upperBound() <= *goal.targetError;
}

} // namespace calotype
