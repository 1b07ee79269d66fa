#include "pack/filter_table.h"

#include <cmath>
#include <numbers>

#include "base/check.h"
#include "shared/limits.h"

namespace calotype {
namespace {

double filterRadius(FilmFilter filter) {
    switch (filter) {
    case FilmFilter::Box:
        return 0.5;
    case FilmFilter::Tent:
        return 1.0;
    case FilmFilter::Gaussian:
    case FilmFilter::BlackmanHarris:
        break;
    }
    return 1.5;
}

/// The integral of the Blackman-Harris window of four terms (Harris 1978) from its centre to the
/// share s of its radius, up to a factor.
double blackmanHarrisIntegral(double s) {
    constexpr double kPi = std::numbers::pi;
    return 0.35875 * s + 0.48829 * std::sin(kPi * s) / kPi +
           0.14128 * std::sin(2.0 * kPi * s) / (2.0 * kPi) +
           0.01168 * std::sin(3.0 * kPi * s) / (3.0 * kPi);
}

/// The weight of the filter in [0, x], for x from 0 to its radius, up to a factor.
double weightWithin(FilmFilter filter, double x) {
    constexpr double kGaussianSigma = 0.5;
    switch (filter) {
    case FilmFilter::Box:
        return x;
    case FilmFilter::Tent:
        return x * (2.0 - x);
    case FilmFilter::Gaussian:
        return std::erf(x / (kGaussianSigma * std::numbers::sqrt2));
    case FilmFilter::BlackmanHarris:
        break;
    }
    return blackmanHarrisIntegral(x / filterRadius(filter));
}

/// The x in [0, radius] such that [0, x] has this weight, by bisection to the last bit.
double distanceWithWeight(FilmFilter filter, double weight) {
    double low = 0.0;
    double high = filterRadius(filter);
    for (double middle = 0.5 * high; low < middle && middle < high; middle = 0.5 * (low + high))
        (weightWithin(filter, middle) < weight ? low : high) = middle;
    return high;
}

} // namespace

std::vector<shared::FilterStep> filterSteps(FilmFilter filter) {
    const double whole = weightWithin(filter, filterRadius(filter));
    std::vector<shared::FilterStep> steps(shared::kFilterSteps);
    float begin = 0.0f;
    for (uint32_t i = 0; i < shared::kFilterSteps; ++i) {
        const auto end =
            static_cast<float>(distanceWithWeight(filter, whole * (i + 1) / shared::kFilterSteps));
        steps[i].quantiles = {begin, end};
        begin = end;
    }
    return steps;
}

} // namespace calotype
