#pragma once

#include "support/oracle_line.h"

namespace calotype::test {

/// Where a line in the cone's frame runs inside the closed cone with its apex at the origin, its
/// base at y = `height` (of either sign) and radius slope |y|, after its side and its base were
/// both moved outward by `growth`.
Interval insideCone(const Line& line, Real height, Real slope, Real growth);

} // namespace calotype::test
