#include "support/oracle_line.h"

#include <cmath>

namespace calotype::test {

std::vector<Real> quadraticRoots(Real a, Real b, Real c) {
    if (a == 0.0L)
        return b == 0.0L ? std::vector<Real>{} : std::vector<Real>{-c / (2.0L * b)};
    const Real discriminant = b * b - a * c;
    if (discriminant < 0.0L)
        return {};
    const Real q = -(b + std::copysign(std::sqrt(discriminant), b));
    return q == 0.0L ? std::vector<Real>{0.0L, 0.0L} : std::vector<Real>{c / q, q / a};
}

} // namespace calotype::test
