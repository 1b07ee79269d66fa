#include "study/measurement.h"

#include <algorithm>
#include <cmath>

namespace calotype {
namespace {

/// Where the line through two points of a log-log plot has the error `target`.
double secondsBetween(const CurvePoint& a, const CurvePoint& b, double target) {
    const double slope = std::log(*b.error / *a.error);
    const double share = slope != 0.0 ? std::log(target / *a.error) / slope : 0.0;
    return a.seconds * std::pow(b.seconds / a.seconds, share);
}

} // namespace

std::optional<double> Measurement::floor() const {
    if (!variant.losesLight)
        return 0.0;
    if (curve.empty() || !isTrusted || !last().error || !last().stated)
        return std::nullopt;
    const double noise = *last().stated;
    return std::sqrt(std::max(0.0, *last().error * *last().error - noise * noise));
}

std::optional<double> Measurement::secondsTo(double target) const {
    const CurvePoint* before = nullptr;
    for (const CurvePoint& point : curve) {
        if (!point.error || point.seconds <= 0.0)
            continue;
        if (*point.error <= target)
            return before ? secondsBetween(*before, point, target) : point.seconds;
        before = &point;
    }
    const auto lowest = floor();
    if (!before || !lowest || target <= *lowest)
        return std::nullopt;
    const double noise = *before->error * *before->error - *lowest * *lowest;
    return before->seconds * std::max(1.0, noise / (target * target - *lowest * *lowest));
}

std::vector<CurvePoint> paretoFront(const std::vector<Measurement>& measurements) {
    std::vector<CurvePoint> points;
    for (const Measurement& measurement : measurements)
        for (const CurvePoint& point : measurement.curve)
            if (point.error && point.seconds > 0.0)
                points.push_back({point.samples, point.seconds, point.error, point.stated, {}});
    std::ranges::sort(
        points, {}, [](const CurvePoint& point) { return std::pair(point.seconds, *point.error); });
    std::vector<CurvePoint> front;
    for (CurvePoint& point : points)
        if (front.empty() || *point.error < *front.back().error)
            front.push_back(std::move(point));
    return front;
}

} // namespace calotype
