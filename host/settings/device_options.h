#pragma once

#include <cstdint>
#include <string>

namespace calotype {

/// What renders, and how it is run.
struct DeviceOptions {
    /// A Vulkan device by its index or a part of its name, in any case; or "reference" for the
    /// reference tracer, in double precision on the CPU. Empty: the best device.
    std::string device;

    /// What messages put before the name: "--device", or the variable that it came from.
    std::string askedBy;

    /// Of the reference tracer; 0: as many as there are cores. lavapipe reads its number of threads
    /// from the environment variable LP_NUM_THREADS when it is loaded.
    uint32_t threads = 0;

    /// Whether Khronos's validation layers check every call of Vulkan. What they say becomes a
    /// GpuError. Slow; for development.
    bool validates = false;
};

} // namespace calotype
