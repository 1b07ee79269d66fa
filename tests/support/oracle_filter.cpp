#include "support/oracle_filter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace calotype::test {
namespace {

constexpr int kSteps = 30'000;

double radiusOf(FilmFilter filter) {
    return filter == FilmFilter::Box ? 0.5 : filter == FilmFilter::Tent ? 1.0 : 1.5;
}

/// Up to a factor, within the radius.
double density(FilmFilter filter, double x) {
    const double phase = std::numbers::pi * (x / 1.5 + 1.0);
    switch (filter) {
    case FilmFilter::Box:
        return 1.0;
    case FilmFilter::Tent:
        return 1.0 - std::abs(x);
    case FilmFilter::Gaussian:
        return std::exp(-2.0 * x * x); // sigma 1/2
    case FilmFilter::BlackmanHarris:
        break;
    }
    // Harris's "4-term, -92 dB" window over one period, from its left end.
    return 0.35875 - 0.48829 * std::cos(phase) + 0.14128 * std::cos(2.0 * phase) -
           0.01168 * std::cos(3.0 * phase);
}

} // namespace

OracleFilter::OracleFilter(FilmFilter filter)
    : radius_(radiusOf(filter)), variance_(0.0), shares_{0.0} {
    const double width = 2.0 * radius_ / kSteps;
    for (int i = 0; i < kSteps; ++i) {
        const double x = -radius_ + (i + 0.5) * width; // the midpoint rule
        const double weight = density(filter, x) * width;
        variance_ += weight * x * x;
        shares_.push_back(shares_.back() + weight);
    }
    const double whole = shares_.back();
    variance_ /= whole;
    for (double& share : shares_)
        share /= whole;
}

double OracleFilter::shareBelow(double x) const {
    const double step = std::clamp((x + radius_) / (2.0 * radius_), 0.0, 1.0) * kSteps;
    const auto index = std::min(static_cast<size_t>(step), shares_.size() - 2);
    const double f = step - static_cast<double>(index);
    return (1.0 - f) * shares_[index] + f * shares_[index + 1];
}

} // namespace calotype::test
