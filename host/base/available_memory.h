#pragma once

#include <cstdint>

namespace calotype {

/// Bytes of main memory and swap that this process can use besides what is in use: what the system
/// reports as available, within the limits of the process and its control group. 2^64 - 1 if the
/// system does not report it.
uint64_t availableMemory();

} // namespace calotype
