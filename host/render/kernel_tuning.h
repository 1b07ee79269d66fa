#pragma once

#include <cstdint>

namespace calotype {

/// When the path tracing kernel goes over from one thing to another: the eighths of the lanes at
/// work that are at least about it while it stays with it. Measured on llvmpipe.
struct KernelTuning {
    uint32_t nodeEighths = 5;      ///< among nodes
    uint32_t primitiveEighths = 3; ///< among primitives
    uint32_t rayEighths = 7;       ///< with a ray under way; others are given their next one
    uint32_t eventEighths = 6;     ///< with a ray at all; else surfaces are met
};

} // namespace calotype
