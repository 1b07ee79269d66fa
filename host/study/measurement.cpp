#include "study/measurement.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <limits>

namespace calotype {
namespace {

/// Where the line through two points of a log-log plot has the error `target`.
double secondsBetween(const CurvePoint& a, const CurvePoint& b, double target) {
    const double slope = std::log(*b.error / *a.error);
    const double share = slope != 0.0 ? std::log(target / *a.error) / slope : 0.0;
    return a.seconds * std::pow(b.seconds / a.seconds, share);
}

constexpr uint32_t kLargestPart = 256; ///< pixels on a side

constexpr double kUnknown = std::numeric_limits<double>::infinity();

/// Points of the front between two measured times.
constexpr int kStepsBetween = 8;

/// The error of a curve after so many seconds: along straight lines of a log-log plot, and behind
/// its end that of its last point. Infinite before its first point.
double errorAt(const std::vector<FrontPoint>& curve, double seconds) {
    const auto after = std::ranges::upper_bound(curve, seconds, std::less(), &FrontPoint::seconds);
    if (after == curve.begin())
        return kUnknown;
    const FrontPoint& before = *std::prev(after);
    if (after == curve.end() || before.seconds == seconds)
        return before.error;
    const double share =
        std::log(seconds / before.seconds) / std::log(after->seconds / before.seconds);
    return before.error * std::pow(after->error / before.error, share);
}

} // namespace

Image middleOf(const Image& image) {
    Image part(std::min(image.width, kLargestPart), std::min(image.height, kLargestPart));
    for (uint32_t y = 0; y < part.height; ++y)
        for (uint32_t x = 0; x < part.width; ++x)
            part.at(x, y) =
                image.at(x + (image.width - part.width) / 2, y + (image.height - part.height) / 2);
    return part;
}

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
    if (variant.isDenoised)
        return std::nullopt;
    const auto lowest = floor();
    if (!before || !lowest || target <= *lowest)
        return std::nullopt;
    const double noise = *before->error * *before->error - *lowest * *lowest;
    return before->seconds * std::max(1.0, noise / (target * target - *lowest * *lowest));
}

bool Measurement::reaches(double target) const {
    return std::ranges::any_of(
        curve, [&](const CurvePoint& point) { return point.error && *point.error <= target; });
}

std::vector<FrontPoint> knownPoints(const Measurement& measurement) {
    std::vector<FrontPoint> points;
    for (const CurvePoint& point : measurement.curve)
        if (point.error && point.seconds > 0.0)
            points.push_back({point.seconds, *point.error});
    return points;
}

std::vector<FrontPoint> paretoFront(const std::vector<Measurement>& measurements) {
    std::vector<std::vector<FrontPoint>> curves;
    std::vector<double> times;
    for (const Measurement& measurement : measurements) {
        curves.push_back(knownPoints(measurement));
        for (const FrontPoint& point : curves.back())
            times.push_back(point.seconds);
    }
    std::ranges::sort(times);
    std::vector<FrontPoint> front;
    for (size_t i = 0; i < times.size(); ++i) {
        const double next = i + 1 < times.size() ? times[i + 1] : times[i];
        for (int step = 0; step < kStepsBetween; ++step) {
            const double seconds =
                step == 0 ? times[i]
                          : times[i] * std::pow(next / times[i], double(step) / kStepsBetween);
            double error = front.empty() ? kUnknown : front.back().error;
            for (const std::vector<FrontPoint>& curve : curves)
                error = std::min(error, errorAt(curve, seconds));
            front.push_back({seconds, error});
        }
    }
    return front;
}

} // namespace calotype
