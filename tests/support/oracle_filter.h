#pragma once

#include <vector>

#include "scene/scene.h"

namespace calotype::test {

/// One factor of a film filter, as the scene format names it: its density over the distance from
/// the pixel's centre along an axis, integrated numerically.
class OracleFilter {
public:
    explicit OracleFilter(FilmFilter filter);

    double radius() const { return radius_; }

    /// The share of the filter below x, in [0, 1].
    double shareBelow(double x) const;

    /// The mean of x^2.
    double variance() const { return variance_; }

private:
    double radius_;
    double variance_;
    std::vector<double> shares_; ///< below the ends of equal steps from -radius to radius
};

} // namespace calotype::test
