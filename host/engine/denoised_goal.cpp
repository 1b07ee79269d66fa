#include "engine/denoised_goal.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <utility>

#include "base/error.h"
#include "math/square.h"

namespace calotype {

double DenoisedGoal::secondsNow() {
    const auto now = std::chrono::steady_clock::now().time_since_epoch();
    return std::chrono::duration<double>(now).count();
}

std::optional<DenoisedError> DenoisedGoal::errorOf(const FilmView& film) {
    if (!isDue(film.samples()))
        return std::nullopt;
    const double before = now_();
    picture_.reset();
    try {
        picture_ = denoise_(film);
    } catch (const Interrupted&) {
        return std::nullopt;
    } catch (const std::exception&) {
        failure_ = std::current_exception();
        return std::nullopt;
    }
    samples_ = film.samples();
    lastEnd_ = now_();
    lastSeconds_ = lastEnd_ - before;
    seconds_ += lastSeconds_;
    return picture_->error;
}

bool DenoisedGoal::isDue(uint64_t samples) const {
    if (!picture_)
        return !failure_;
    if (now_() - lastEnd_ < lastSeconds_)
        return false;
    if (!picture_->error)
        return true;
    // One uncertain bound must not put off the next look for long.
    constexpr double kMostGrowth = 2.0;
    const double growth = square(picture_->error->upperBound / targetError_);
    return static_cast<double>(samples) >=
           static_cast<double>(samples_) * std::min(growth, kMostGrowth);
}

std::optional<CleanPicture> DenoisedGoal::take(const FilmView& film) {
    if (!picture_ || samples_ != film.samples())
        return std::nullopt;
    return std::exchange(picture_, std::nullopt);
}

} // namespace calotype
