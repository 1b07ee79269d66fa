#pragma once

#include <cstdint>
#include <string>

#include "engine/bench.h"

namespace calotype {

/// A few lines for people. `scene` is its name.
std::string toText(const std::string& scene, const BenchReport& report);

/// One line of JSON, ended. `threads` are those of a CPU as device; 0: all cores.
std::string toJsonLine(const std::string& scene, const BenchReport& report, uint32_t threads);

} // namespace calotype
