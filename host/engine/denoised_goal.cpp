#include "engine/denoised_goal.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "base/error.h"
#include "base/stopwatch.h"
#include "math/square.h"

namespace calotype {

std::optional<DenoisedError> DenoisedGoal::errorOf(const Film& film,
                                                   const PictureDenoiser::OnProgress& onProgress) {
    if (!isDue(film.samplesPerPixel()))
        return std::nullopt;
    const Clock::time_point before = Clock::now();
    picture_.reset();
    try {
        picture_ = denoiser_.run(film, film.picture(), features_, threads_, onProgress);
    } catch (const Interrupted&) {
        return std::nullopt;
    } catch (const std::exception&) {
        failure_ = std::current_exception();
        return std::nullopt;
    }
    samples_ = film.samplesPerPixel();
    lastEnd_ = Clock::now();
    lastSeconds_ = secondsSince(before);
    seconds_ += lastSeconds_;
    return picture_->error;
}

bool DenoisedGoal::isDue(uint64_t samples) const {
    if (!picture_)
        return !failure_;
    if (secondsSince(lastEnd_) < lastSeconds_)
        return false;
    if (!picture_->error)
        return true;
    // One uncertain bound must not put off the next look for long.
    constexpr double kMostGrowth = 2.0;
    const double growth = square(picture_->error->upperBound / targetError_);
    return static_cast<double>(samples) >=
           static_cast<double>(samples_) * std::min(growth, kMostGrowth);
}

std::optional<CleanPicture> DenoisedGoal::take(const Film& film) {
    if (!picture_ || samples_ != film.samplesPerPixel())
        return std::nullopt;
    return std::exchange(picture_, std::nullopt);
}

} // namespace calotype
