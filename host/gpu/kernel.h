#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace calotype {

class Device;

struct KernelInfo {
    std::string name; ///< for validation messages and debuggers
    std::span<const uint32_t> spirv;
    std::vector<vk::DescriptorSetLayoutBinding> bindings = {}; ///< of set 0
    std::vector<uint32_t> constants = {}; ///< specialization constants by identifier, a word each
    uint32_t pushConstantBytes = 0;
};

/// A compiled kernel, without the resources that it reads and writes.
class Kernel {
public:
    Kernel(const Device& device, const KernelInfo& info);

    const vk::DescriptorSetLayout& setLayout() const { return *setLayout_; }
    vk::PipelineLayout layout() const { return *layout_; }
    vk::Pipeline pipeline() const { return *pipeline_; }

private:
    vk::raii::DescriptorSetLayout setLayout_ = nullptr;
    vk::raii::PipelineLayout layout_ = nullptr;
    vk::raii::Pipeline pipeline_ = nullptr;
};

/// The kernels that a device has compiled: pipelines of one device share them. Drops the one that
/// was used least recently where there are more than kMostKernels, except those in use.
class KernelStore {
public:
    static constexpr size_t kMostKernels = 64; ///< a few megabytes each on llvmpipe

    /// The kernel of this code, these bindings and constants; compiles it where there is none yet.
    std::shared_ptr<const Kernel> get(const Device& device, const KernelInfo& info);

    size_t size() const { return entries_.size(); }

private:
    struct Entry {
        uint64_t key = 0;
        std::shared_ptr<const Kernel> kernel;
    };

    std::vector<Entry> entries_; ///< the one that was used last is at the end
};

} // namespace calotype
