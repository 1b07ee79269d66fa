#pragma once

#include <cstdint>
#include <string>

namespace calotype {

/// The device that renders, and its options.
struct DeviceOptions {
    /// A Vulkan device by its index, a part of its name or driver, in any case, its UUID or its PCI
    /// address; or "reference" for the
    /// reference tracer, in double precision on the CPU. Empty: the best device.
    std::string device;

    /// The source of the name, for messages: "--device", or an environment variable.
    std::string askedBy;

    /// The library of Open Image Denoise, or its folder. Empty: in the folder "oidn/lib" beside the
    /// program, or else of the system.
    std::string denoiserLibrary;

    /// Folder for compiled kernels, made if there is none. Empty: $XDG_CACHE_HOME/calotype, or else
    /// ~/.cache/calotype.
    std::string cacheFolder;

    /// Threads of the reference tracer; 0: one for each core. lavapipe reads its number of threads
    /// from the environment variable LP_NUM_THREADS when it is loaded.
    uint32_t threads = 0;

    /// Whether Khronos's validation layers check every call of Vulkan. Their messages become a
    /// GpuError. Slow; for development.
    bool validates = false;
};

} // namespace calotype
