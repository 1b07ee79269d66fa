#pragma once

namespace calotype {

constexpr double square(double x) { return x * x; }

} // namespace calotype
