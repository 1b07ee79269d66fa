#pragma once

#include <cstdint>

#include "gpu/device_info.h"

namespace calotype {

/// What suits the path tracing kernel to a device. It goes over from one thing to another when
/// fewer than so many eighths of the lanes at work are about it; measured on llvmpipe.
struct KernelTuning {
    uint32_t nodeEighths = 5;      ///< among nodes
    uint32_t primitiveEighths = 3; ///< among primitives
    uint32_t rayEighths = 7;       ///< with a ray under way; others are given their next one
    uint32_t eventEighths = 6;     ///< with a ray at all; else surfaces are met
    bool sharesStack = false;      ///< rays put nodes aside in memory shared by the workgroup
};

/// By the kind of device. On llvmpipe a shared stack takes 6 % more time; GPUs keep a lane's own
/// arrays in the memory that is farthest away, so there it is shared, which is not measured.
KernelTuning tuningFor(const DeviceInfo& device);

} // namespace calotype
