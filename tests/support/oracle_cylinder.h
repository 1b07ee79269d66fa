#pragma once

#include "support/oracle_line.h"

namespace calotype::test {

/// Where a line in the cylinder's frame runs inside the closed cylinder of `radius` about the y
/// axis with |y| <= halfHeight.
Interval insideCylinder(const Line& line, Real radius, Real halfHeight);

} // namespace calotype::test
