#pragma once

#include <optional>
#include <vector>

#include "film/adaptive_film.h"
#include "film/film.h"
#include "image/pixel_error.h"

namespace calotype {

/// How far a picture may be from what it would become with endless samples: one number, from the
/// spread of the film's replicas about their mean.
///
/// With L a pixel's luminance, v the estimated variance of L, and mean over all pixels:
///
///     relative = 1.96 sqrt(mean(v / (L^2 + (0.01 mean L)^2)))
///
/// 1.96 standard errors reach as far as 95 % of normally distributed errors do; the second term
/// keeps pixels that are almost black from counting more than those that can be seen.
struct ErrorEstimate {
    double relative = 0.0;
    /// Standard error of `relative` squared, as a share of it: v is itself an estimate.
    double uncertainty = 0.0;
    /// By which factor `relative` grows when each replica's deviation is divided not by the L that
    /// it is part of but by that of the other replicas: near 1 where all see the same picture,
    /// large where rare samples bring most of a pixel's light. Only known of all replicas together.
    std::optional<double> doubt;
    uint32_t replicas = 0; ///< that hold samples

    /// False where the estimate rests on rare bright samples, so that light may be missing
    /// altogether; or on too few replicas to tell.
    bool isTrusted() const;

    /// What v without its noise would give at most, but for a chance of 1 in 400: 5 % shared by the
    /// looks at 128, 256, ... samples that a render may end with. Infinite where v is hardly known.
    double upperBound() const;
};

/// The formula above, as a sum over pixels: of one pixel, `variance` (or a squared deviation) over
/// L^2 + (0.01 mean L)^2; and of the mean of those, `relative`.
double relativeShare(double variance, double luminance, double meanLuminance);
double relativeError(double meanShare);

/// None of a film that holds fewer than two replicas (of an adaptive film, in each half of each
/// pixel), or is black, so that light may be missing.
std::optional<ErrorEstimate> estimateError(const Film& film);
std::optional<ErrorEstimate> estimateError(const AdaptiveFilm& film);

/// Row by row from the top left pixel: the intervals are Student's t, for the replicas that hold
/// samples, times the standard errors; of an adaptive film with Welch's degrees of freedom for the
/// mean of two halves. Infinite where the replicas are too few.
std::vector<PixelError> pixelErrors(const Film& film);
std::vector<PixelError> pixelErrors(const AdaptiveFilm& film);

} // namespace calotype
