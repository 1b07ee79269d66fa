#pragma once

namespace calotype {

/// The distance of a denoised picture from its limit with infinitely many samples, in the measure
/// of ErrorEstimate::relative.
struct DenoisedError {
    double relative = 0.0;
    double bound = 0.0; ///< the true one is below it with a probability of 95 %
    /// Likewise for renders that end by it: wrong with the probability of
    /// ErrorEstimate::upperBound.
    double upperBound = 0.0;
};

/// From an unbiased estimate of the mean of relativeShare, and its standard error.
DenoisedError denoisedErrorOf(double share, double standardError);

} // namespace calotype
