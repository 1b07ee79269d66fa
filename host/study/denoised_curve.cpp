#include "study/denoised_curve.h"

#include <algorithm>
#include <bit>
#include <chrono>
#include <utility>

#include "base/stopwatch.h"

namespace calotype {
namespace {

/// Ends denoising that would take too long.
struct TooLong {};

/// By this factor denoising may take more than the time that is left, as it is expected to take
/// from this share of it on. The first runs of a denoiser are slow.
constexpr double kMostExcess = 1.5;
constexpr double kKnownFrom = 0.3;

} // namespace

void DenoisedCurve::onPass() {
    const uint64_t samples = session_.filmView().samplesPerPixel();
    if (samples < next_ || isOver())
        return;
    record();
    next_ = std::bit_ceil(samples + 1);
}

double DenoisedCurve::secondsTaken() const {
    return prepared_.featureSeconds + session_.totals().seconds + denoiseSeconds_;
}

bool DenoisedCurve::isOver() const {
    return isTooLong_ || secondsTaken() + lastDenoiseSeconds_ >= seconds_;
}

void DenoisedCurve::finish() {
    const FilmView film = session_.filmView();
    if (!isTooLong_ && film.samplesPerPixel() >= kFirstLook && film.samples() > samples_)
        record();
}

void DenoisedCurve::record() {
    const double left = std::max(seconds_ - secondsTaken(), lastDenoiseSeconds_);
    const auto before = std::chrono::steady_clock::now();
    const auto onProgress = [&](double done) {
        onProgress_();
        if (done > kKnownFrom && done < 1.0 && secondsSince(before) > kMostExcess * done * left)
            throw TooLong();
    };
    const FilmView film = session_.filmView();
    try {
        CleanPicture clean = prepared_.denoise(film, onProgress);
        lastDenoiseSeconds_ = secondsSince(before);
        denoiseSeconds_ += lastDenoiseSeconds_;
        CurvePoint point{static_cast<double>(film.samplesPerPixel()),
                         prepared_.featureSeconds + session_.totals().seconds + lastDenoiseSeconds_,
                         truth_.errorOf(clean.color),
                         {},
                         middleOf(clean.color),
                         {}};
        if (clean.error) {
            point.stated = clean.error->relative;
            point.bound = clean.error->bound;
        }
        points_.push_back(std::move(point));
        picture_ = std::move(clean.color);
        samples_ = film.samples();
    } catch (const TooLong&) {
        denoiseSeconds_ += secondsSince(before);
        isTooLong_ = true;
    }
}

} // namespace calotype
