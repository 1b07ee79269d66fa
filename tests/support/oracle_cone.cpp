#include "support/oracle_cone.h"

#include <cmath>

namespace calotype::test {

Interval insideCone(const Line& line, Real height, Real slope, Real growth) {
    // A cone whose side moves outward is the same cone, its apex moved away from the base.
    const Real apexShift = growth * std::sqrt(1.0L + slope * slope) / slope;
    const Real depth = std::abs(height) + growth + apexShift;
    if (depth < 0.0L)
        return {};
    const auto fromApex = [&](const Vec3& v, Real shift) {
        return Vec3(v.x, std::copysign(1.0L, height) * v.y + shift, v.z);
    };
    const Line shifted{fromApex(line.origin, apexShift), fromApex(line.direction, 0.0L)};
    const Vec3 o = shifted.origin;
    const Vec3 d = shifted.direction;
    const Real kk = slope * slope;
    std::vector<Real> cuts = quadraticRoots(d.x * d.x + d.z * d.z - kk * d.y * d.y,
                                            o.x * d.x + o.z * d.z - kk * o.y * d.y,
                                            o.x * o.x + o.z * o.z - kk * o.y * o.y);
    if (d.y != 0.0L)
        cuts.insert(cuts.end(), {-o.y / d.y, (depth - o.y) / d.y});
    return insideInterval(cuts, shifted, [&](const Vec3& p) {
        return p.y >= 0.0L && p.y <= depth && std::hypot(p.x, p.z) <= slope * p.y;
    });
}

} // namespace calotype::test
