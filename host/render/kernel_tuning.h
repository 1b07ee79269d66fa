#pragma once

#include <cstdint>

#include "gpu/device_info.h"

namespace calotype {

/// Adapts the path tracing kernel to a device. The kernel ends one kind of work when fewer than
/// this many eighths of the working lanes need it; measured on llvmpipe.
struct KernelTuning {
    uint32_t nodeEighths = 5;      ///< lanes that visit nodes
    uint32_t primitiveEighths = 3; ///< lanes that test primitives
    uint32_t rayEighths = 7;       ///< lanes whose ray is not finished; the others wait for theirs
    uint32_t eventEighths = 6;     ///< lanes that have a ray; below, paths take their steps
    bool sharesStack = false;      ///< rays keep their stack in memory shared by the workgroup
};

/// The tuning for the kind of device. On llvmpipe a shared stack takes 6 % more time. GPUs keep
/// arrays of a lane in the slowest memory, so there the stack is shared; this is not measured.
KernelTuning tuningFor(const DeviceInfo& device);

} // namespace calotype
