#pragma once

#include <filesystem>

#include "gpu/vulkan.h"

namespace calotype {

/// Compiled kernels, kept on disk from one run to the next: in $XDG_CACHE_HOME/calotype or
/// ~/.cache/calotype, a file for each device and driver. Where there is no such folder, or its file
/// is damaged, kernels are compiled anew: nothing fails for it.
class PipelineCache {
public:
    PipelineCache(const vk::PhysicalDeviceProperties& properties, const vk::raii::Device& device);

    const vk::raii::PipelineCache& handle() const { return cache_; }

    /// Writes the file if there is more to keep than it holds.
    void store();

private:
    std::filesystem::path file_; ///< empty: none
    vk::raii::PipelineCache cache_;
    size_t storedBytes_ = 0;
};

} // namespace calotype
