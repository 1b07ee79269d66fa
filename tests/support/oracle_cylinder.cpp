#include "support/oracle_cylinder.h"

#include <cmath>

namespace calotype::test {

Interval insideCylinder(const Line& line, Real radius, Real halfHeight) {
    if (radius < 0.0L || halfHeight < 0.0L)
        return {};
    const Vec3 o = line.origin;
    const Vec3 d = line.direction;
    std::vector<Real> cuts = quadraticRoots(d.x * d.x + d.z * d.z, o.x * d.x + o.z * d.z,
                                            o.x * o.x + o.z * o.z - radius * radius);
    if (d.y != 0.0L)
        cuts.insert(cuts.end(), {(-halfHeight - o.y) / d.y, (halfHeight - o.y) / d.y});
    return insideInterval(cuts, line, [&](const Vec3& p) {
        return std::abs(p.y) <= halfHeight && std::hypot(p.x, p.z) <= radius;
    });
}

} // namespace calotype::test
