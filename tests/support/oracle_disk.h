#pragma once

#include "support/oracle_quadric.h"

namespace calotype::test {

/// As allowedAnswers, for the disk of `radius` in the plane y = 0 of the line's frame.
AllowedAnswers diskAnswers(const Line& line, Real radius, Real tolerance);

/// The exact hit, or infinity.
Real firstDiskHit(const Line& line, Real radius);

} // namespace calotype::test
