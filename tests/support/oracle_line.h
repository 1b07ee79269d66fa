#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Textbook geometry in extended precision, to hold the shaders to. Written apart from them and by
/// other formulas; it takes the very floats that they take.
namespace calotype::test {

using Real = long double;
using Vec3 = glm::vec<3, Real>;
using Vec2 = glm::vec<2, Real>;

/// The unit of the stated bounds: the shaders' kUnitRoundoff.
inline constexpr Real kRoundoff = 0x1p-23L;

inline constexpr Real kInfinity = std::numeric_limits<Real>::infinity();

struct Line {
    Vec3 origin;
    Vec3 direction;

    Vec3 at(Real t) const { return origin + t * direction; }
};

/// Parameters t with enter <= t <= leave. Default: empty.
struct Interval {
    Real enter = kInfinity;
    Real leave = -kInfinity;

    bool isEmpty() const { return enter > leave; }
    bool contains(Real t) const { return enter <= t && t <= leave; }
};

/// The real roots of a t^2 + 2 b t + c. For a = 0 the one of the linear equation.
std::vector<Real> quadraticRoots(Real a, Real b, Real c);

/// Where a line runs inside a convex solid, given every parameter at which it may cross the
/// boundary and a test of single points.
template <typename IsInside>
Interval insideInterval(std::vector<Real> cuts, const Line& line, const IsInside& isInside) {
    std::sort(cuts.begin(), cuts.end());
    Interval inside;
    for (size_t i = 1; i < cuts.size(); ++i) {
        if (!isInside(line.at(0.5L * (cuts[i - 1] + cuts[i]))))
            continue;
        inside.enter = std::min(inside.enter, cuts[i - 1]);
        inside.leave = std::max(inside.leave, cuts[i]);
    }
    return inside;
}

} // namespace calotype::test
