#pragma once

#include <exception>
#include <functional>
#include <optional>
#include <utility>

#include "denoise/film_view.h"
#include "engine/clean_picture.h"

namespace calotype {

/// Denoises a film from time to time while it is rendered, to end the render when the picture after
/// denoising is good enough.
class DenoisedGoal {
public:
    /// Denoises the whole blocks of a film. May throw Interrupted to end the work.
    using Denoise = std::function<CleanPicture(const FilmView&)>;

    /// `now` returns seconds since any fixed moment.
    DenoisedGoal(double targetError, Denoise denoise, std::function<double()> now = secondsNow)
        : targetError_(targetError), denoise_(std::move(denoise)), now_(std::move(now)) {}

    /// The error of the film after denoising. None where it is most likely above the target, until
    /// as much time has passed as denoising took before, where nobody can state the error, or if
    /// denoising fails: then the render should end.
    std::optional<DenoisedError> errorOf(const FilmView& film);

    /// The picture of the last errorOf, if the film had as many samples as now.
    std::optional<CleanPicture> take(const FilmView& film);

    /// Why denoising failed; null if it did not.
    std::exception_ptr failure() const { return failure_; }

    double seconds() const { return seconds_; } ///< of denoising, all together

private:
    static double secondsNow();

    /// Errors fall with the root of the samples, or slower.
    bool isDue(uint64_t samples) const;

    double targetError_;
    Denoise denoise_;
    std::function<double()> now_;
    std::optional<CleanPicture> picture_;
    std::exception_ptr failure_;
    uint64_t samples_ = 0; ///< of all pixels, of `picture_`
    double seconds_ = 0.0;
    double lastSeconds_ = 0.0; ///< of denoising `picture_`
    double lastEnd_ = 0.0;     ///< by now_
};

} // namespace calotype
