#include "support/oracle_disk.h"

#include <cmath>

namespace calotype::test {
namespace {

Real distanceFromAxis(const Line& line, Real t) {
    const Vec3 p = line.at(t);
    return std::hypot(p.x, p.z);
}

} // namespace

AllowedAnswers diskAnswers(const Line& line, Real radius, Real tolerance) {
    AllowedAnswers allowed;
    allowed.miss = true;
    if (line.direction.y == 0.0L)
        return allowed;
    const Real first = (-tolerance - line.origin.y) / line.direction.y;
    const Real second = (tolerance - line.origin.y) / line.direction.y;
    allowed.entry = {std::min(first, second), std::max(first, second)};
    const Real from = distanceFromAxis(line, allowed.entry.enter);
    const Real to = distanceFromAxis(line, allowed.entry.leave);
    allowed.miss = allowed.entry.enter <= 0.0L || std::max(from, to) > radius - tolerance;
    // Along the crossing of a layer as thin as the tolerance, the nearest point to the axis.
    const Vec3 d = line.direction;
    const Real dd = d.x * d.x + d.z * d.z;
    const Real nearest = dd > 0.0L ? -(line.origin.x * d.x + line.origin.z * d.z) / dd : 0.0L;
    const Real t = std::clamp(nearest, allowed.entry.enter, allowed.entry.leave);
    if (distanceFromAxis(line, t) > radius + tolerance)
        allowed.entry = {};
    return allowed;
}

Real firstDiskHit(const Line& line, Real radius) {
    if (line.direction.y == 0.0L)
        return kInfinity;
    const Real t = -line.origin.y / line.direction.y;
    return t > 0.0L && distanceFromAxis(line, t) <= radius ? t : kInfinity;
}

} // namespace calotype::test
