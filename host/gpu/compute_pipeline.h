#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/kernel.h"
#include "gpu/storage_image.h"
#include "gpu/vulkan.h"

namespace calotype {

/// A resource at a binding of set 0.
struct Binding {
    uint32_t index = 0;
    vk::DescriptorType type{};
    vk::BufferView texels{};
    vk::DescriptorBufferInfo buffer{};
    vk::DescriptorImageInfo image{};

    static Binding texelBuffer(uint32_t index, const TexelBuffer& buffer);
    static Binding uniformBuffer(uint32_t index, const Buffer& buffer);
    static Binding storageBuffer(uint32_t index, const Buffer& buffer);
    static Binding storageImage(uint32_t index, const StorageImage& image);
};

struct ComputePipelineInfo {
    std::string name;
    std::span<const uint32_t> spirv;
    std::vector<Binding> bindings;   ///< must outlive the pipeline
    std::vector<uint32_t> constants; ///< as in KernelInfo
    uint32_t pushConstantBytes = 0;
};

/// One kernel with its resources, which are bound permanently. Pipelines of the same code, bindings
/// and constants share the compiled kernel.
class ComputePipeline {
public:
    ComputePipeline(const Device& device, const ComputePipelineInfo& info);

    /// Runs `groups` workgroups and waits for them; then their results are visible to the host.
    void run(const Device& device, uint32_t groups,
             std::span<const std::byte> pushConstants = {}) const;

private:
    std::shared_ptr<const Kernel> kernel_;
    vk::raii::DescriptorPool pool_ = nullptr;
    vk::DescriptorSet set_; // freed with its pool
};

} // namespace calotype
