#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace calotype::reference {

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Parameters t with enter <= t <= leave: the part of a line inside a convex solid.
struct Interval {
    double enter = -kInfinity; ///< by default the whole line
    double leave = kInfinity;

    static Interval nowhere() { return {kInfinity, -kInfinity}; }

    static Interval between(double a, double b) { return {std::min(a, b), std::max(a, b)}; }
};

inline Interval intersection(const Interval& a, const Interval& b) {
    return {std::max(a.enter, b.enter), std::min(a.leave, b.leave)};
}

/// The interval with lower <= y + t dy <= upper. An origin within `tolerance` of a plane is on it.
inline Interval insideSlab(double y, double dy, double lower, double upper, double tolerance) {
    if (dy == 0.0)
        return lower <= y && y <= upper ? Interval() : Interval::nowhere();
    const auto crossing = [&](double plane) {
        return std::abs(plane - y) <= tolerance ? 0.0 : (plane - y) / dy;
    };
    return Interval::between(crossing(lower), crossing(upper));
}

/// The first t > 0 at which a ray crosses the boundary of a solid; `inside` is the interval of its
/// line in the solid. An origin on the boundary, at t = 0, is not a crossing.
inline std::optional<double> firstCrossing(const Interval& inside) {
    if (inside.enter > inside.leave || inside.leave <= 0.0)
        return std::nullopt;
    return inside.enter > 0.0 ? inside.enter : inside.leave;
}

} // namespace calotype::reference
