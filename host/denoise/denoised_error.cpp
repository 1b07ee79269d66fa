#include "denoise/denoised_error.h"

#include <algorithm>

#include "film/error_estimate.h"
#include "film/looks.h"

namespace calotype {

DenoisedError denoisedErrorOf(double share, double standardError) {
    constexpr double kNormalQuantile95 = 1.645; // one-sided
    const auto above = [&](double quantile) {
        return relativeError(std::max(share + quantile * standardError, 0.0));
    };
    return {above(0.0), above(kNormalQuantile95), above(kSharedQuantile)};
}

} // namespace calotype
