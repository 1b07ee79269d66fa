#pragma once

#include "support/oracle_line.h"

namespace calotype::test {

/// Where a line in the sphere's frame runs inside the ball of `radius`.
Interval insideSphere(const Line& line, Real radius);

} // namespace calotype::test
