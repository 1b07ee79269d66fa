#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "image/pixel_error.h"

namespace calotype {

class AdaptiveFilm;
class Film;

/// How far an estimate can be relied on.
enum class Trust : uint8_t {
    TooFewSamples, ///< below 128 samples per pixel not all replicas hold samples
    RareLight,     ///< it depends on rare bright samples, so that light may be missing altogether
    Trusted,
};

/// The distance of a picture from its limit with infinitely many samples: one number, from the
/// spread of the film's replicas about their mean.
///
/// With L a pixel's luminance, v the estimated variance of L, and mean over all pixels:
///
///     relative = 1.96 sqrt(mean(v / (L^2 + (0.01 mean L)^2)))
///
/// 95 % of normally distributed errors are within 1.96 standard errors. The second term limits the
/// weight of pixels that are almost black.
struct ErrorEstimate {
    double relative = 0.0;
    /// Standard error of `relative` squared, as a share of it: v is itself an estimate.
    double uncertainty = 0.0;
    /// The factor by which `relative` grows when each replica's deviation is divided by the mean
    /// luminance of the other replicas instead of L: near 1 where the replicas agree, large where
    /// most of a pixel's light comes from rare samples. Present only if all replicas have samples.
    std::optional<double> doubt = {};
    uint32_t replicas = 0; ///< that hold samples

    Trust trust() const;
    bool isTrusted() const { return trust() == Trust::Trusted; }

    /// An upper bound of what `relative` would be if v had no noise, wrong with a probability of
    /// 1/3060: 5 % over all looks (film/looks.h). Infinite where v is too uncertain.
    double upperBound() const;
};

/// The two parts of the formula above: for one pixel, `variance` (or a squared deviation) over
/// L^2 + (0.01 mean L)^2; and `relative` from the mean of these over all pixels.
double relativeShare(double variance, double luminance, double meanLuminance);
double relativeError(double meanShare);

/// None for a film that holds fewer than two replicas (an adaptive film: in each half of each
/// pixel), or is black, so that light may be missing.
std::optional<ErrorEstimate> estimateError(const Film& film);
std::optional<ErrorEstimate> estimateError(const AdaptiveFilm& film);

/// Row by row from the top left pixel: the intervals are Student's t, for the replicas that hold
/// samples, times the standard errors; of an adaptive film with Welch's degrees of freedom for the
/// mean of two halves. Infinite where the replicas are too few.
std::vector<PixelError> pixelErrors(const Film& film);
std::vector<PixelError> pixelErrors(const AdaptiveFilm& film);

} // namespace calotype
