#pragma once

#include <cstdint>
#include <string>

#include "engine/bench.h"

namespace calotype {

/// A report of a few lines for users. `scene` is its name.
std::string toText(const std::string& scene, const BenchReport& report);

/// One line of JSON with a line break. `threads` is that of a CPU as device; 0: all cores.
std::string toJsonLine(const std::string& scene, const BenchReport& report, uint32_t threads);

} // namespace calotype
