#include "gpu/compute_pipeline.h"

#include "base/check.h"

namespace calotype {

Binding Binding::texelBuffer(uint32_t index, const TexelBuffer& buffer) {
    Binding binding{index, vk::DescriptorType::eUniformTexelBuffer};
    binding.texels = buffer.view();
    return binding;
}

Binding Binding::uniformBuffer(uint32_t index, const Buffer& buffer) {
    Binding binding{index, vk::DescriptorType::eUniformBuffer};
    binding.buffer = vk::DescriptorBufferInfo(buffer.handle(), 0, VK_WHOLE_SIZE);
    return binding;
}

Binding Binding::storageBuffer(uint32_t index, const Buffer& buffer) {
    Binding binding{index, vk::DescriptorType::eStorageBuffer};
    binding.buffer = vk::DescriptorBufferInfo(buffer.handle(), 0, VK_WHOLE_SIZE);
    return binding;
}

Binding Binding::storageImage(uint32_t index, const StorageImage& image) {
    Binding binding{index, vk::DescriptorType::eStorageImage};
    binding.image = vk::DescriptorImageInfo({}, image.view(), vk::ImageLayout::eGeneral);
    return binding;
}

ComputePipeline::ComputePipeline(const Device& device, const ComputePipelineInfo& info) {
    KernelInfo kernelInfo{info.name, info.spirv, {}, info.constants, info.pushConstantBytes};
    for (const Binding& binding : info.bindings)
        kernelInfo.bindings.push_back(
            {binding.index, binding.type, 1, vk::ShaderStageFlagBits::eCompute});
    kernel_ = device.kernels().get(device, kernelInfo);
    callVulkan([&] {
        const auto& handle = device.handle();
        std::vector<vk::DescriptorPoolSize> poolSizes;
        for (const Binding& binding : info.bindings)
            poolSizes.push_back({binding.type, 1});
        pool_ = handle.createDescriptorPool({{}, 1, poolSizes});
        set_ = (*handle).allocateDescriptorSets({*pool_, kernel_->setLayout()},
                                                *handle.getDispatcher())[0];
        std::vector<vk::WriteDescriptorSet> writes;
        for (const Binding& binding : info.bindings)
            writes.push_back({set_, binding.index, 0, 1, binding.type, &binding.image,
                              &binding.buffer, &binding.texels});
        handle.updateDescriptorSets(writes, {});
    });
}

void ComputePipeline::run(const Device& device, uint32_t groups,
                          std::span<const std::byte> pushConstants) const {
    CALOTYPE_CHECK_LE(groups, device.limits().maxComputeWorkGroupCount[0]);
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, kernel_->pipeline());
        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, kernel_->layout(), 0, set_,
                                    {});
        if (!pushConstants.empty())
            commands.pushConstants<std::byte>(
                kernel_->layout(), vk::ShaderStageFlagBits::eCompute, 0,
                vk::ArrayProxy(static_cast<uint32_t>(pushConstants.size()), pushConstants.data()));
        commands.dispatch(groups, 1, 1);
        const vk::MemoryBarrier done(
            vk::AccessFlagBits::eShaderWrite,
            vk::AccessFlagBits::eShaderRead | vk::AccessFlagBits::eShaderWrite |
                vk::AccessFlagBits::eTransferRead | vk::AccessFlagBits::eHostRead |
                vk::AccessFlagBits::eHostWrite);
        commands.pipelineBarrier(vk::PipelineStageFlagBits::eComputeShader,
                                 vk::PipelineStageFlagBits::eComputeShader |
                                     vk::PipelineStageFlagBits::eTransfer |
                                     vk::PipelineStageFlagBits::eHost,
                                 {}, done, {}, {});
    });
}

} // namespace calotype
