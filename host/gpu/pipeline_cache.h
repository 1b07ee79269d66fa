#pragma once

#include <filesystem>

#include "gpu/vulkan.h"

namespace calotype {

/// Compiled kernels, stored on disk for later runs: one file for each device and driver. If there
/// is no folder for them, or the file is damaged, kernels are compiled again; that is not an error.
class PipelineCache {
public:
    /// An empty `folder` means $XDG_CACHE_HOME/calotype, or else ~/.cache/calotype.
    PipelineCache(const vk::PhysicalDeviceProperties& properties, const vk::raii::Device& device,
                  const std::filesystem::path& folder = {});

    const vk::raii::PipelineCache& handle() const { return cache_; }

    /// Writes the file if the cache has more than it.
    void store();

private:
    std::filesystem::path file_; ///< empty: none
    vk::raii::PipelineCache cache_;
    size_t storedBytes_ = 0;
};

} // namespace calotype
