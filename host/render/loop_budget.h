#pragma once

#include <cstdint>

#include "gpu/device.h"

namespace calotype {

/// How many loop iterations a subgroup may take in one dispatch.
uint32_t loopBudget(const Device& device);

} // namespace calotype
