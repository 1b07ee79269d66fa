#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/device.h"
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
    std::vector<Binding> bindings;     ///< must outlive the pipeline
    std::vector<vk::Bool32> constants; ///< specialization constants by identifier, all booleans
    uint32_t pushConstantBytes = 0;
};

/// One kernel with its resources, which are bound permanently.
class ComputePipeline {
public:
    ComputePipeline(const Device& device, const ComputePipelineInfo& info);

    /// Runs `groups` workgroups and waits for them; then their results are visible to the host.
    void run(const Device& device, uint32_t groups,
             std::span<const std::byte> pushConstants = {}) const;

private:
    vk::raii::DescriptorSetLayout setLayout_ = nullptr;
    vk::raii::PipelineLayout layout_ = nullptr;
    vk::raii::Pipeline pipeline_ = nullptr;
    vk::raii::DescriptorPool pool_ = nullptr;
    vk::DescriptorSet set_; // freed with its pool
};

} // namespace calotype
