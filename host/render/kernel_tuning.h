#pragma once

#include <cstdint>

namespace calotype {

/// When the path tracing kernel goes over from one thing to another: the eighths of the lanes at
/// work that are at least about it while it stays with it. Measured on llvmpipe.
struct KernelTuning {
    uint32_t nodeEighths = 7;
    uint32_t primitiveEighths = 5;
    uint32_t pathEighths = 6;
};

} // namespace calotype
