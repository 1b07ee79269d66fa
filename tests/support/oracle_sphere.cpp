#include "support/oracle_sphere.h"

namespace calotype::test {

Interval insideSphere(const Line& line, Real radius) {
    if (radius < 0.0L)
        return {};
    const std::vector<Real> cuts = quadraticRoots(
        glm::dot(line.direction, line.direction), glm::dot(line.origin, line.direction),
        glm::dot(line.origin, line.origin) - radius * radius);
    return insideInterval(cuts, line,
                          [&](const Vec3& p) { return glm::dot(p, p) <= radius * radius; });
}

} // namespace calotype::test
