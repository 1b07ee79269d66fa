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
    callVulkan([&] {
        const auto& handle = device.handle();
        std::vector<vk::DescriptorSetLayoutBinding> layoutBindings;
        std::vector<vk::DescriptorPoolSize> poolSizes;
        for (const Binding& binding : info.bindings) {
            layoutBindings.push_back(
                {binding.index, binding.type, 1, vk::ShaderStageFlagBits::eCompute});
            poolSizes.push_back({binding.type, 1});
        }
        setLayout_ = handle.createDescriptorSetLayout({{}, layoutBindings});
        pool_ = handle.createDescriptorPool({{}, 1, poolSizes});
        set_ = (*handle).allocateDescriptorSets({*pool_, *setLayout_}, *handle.getDispatcher())[0];
        std::vector<vk::WriteDescriptorSet> writes;
        for (const Binding& binding : info.bindings)
            writes.push_back({set_, binding.index, 0, 1, binding.type, &binding.image,
                              &binding.buffer, &binding.texels});
        handle.updateDescriptorSets(writes, {});

        const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0,
                                          info.pushConstantBytes);
        layout_ = handle.createPipelineLayout(
            {{}, 1, &*setLayout_, info.pushConstantBytes > 0 ? 1u : 0u, &range});
        std::vector<vk::SpecializationMapEntry> entries;
        for (uint32_t id = 0; id < info.constants.size(); ++id)
            entries.push_back(
                {id, static_cast<uint32_t>(id * sizeof(vk::Bool32)), sizeof(vk::Bool32)});
        const vk::SpecializationInfo specialization(
            static_cast<uint32_t>(entries.size()), entries.data(),
            info.constants.size() * sizeof(vk::Bool32), info.constants.data());
        const auto module =
            handle.createShaderModule({{}, info.spirv.size_bytes(), info.spirv.data()});
        const vk::PipelineShaderStageCreateInfo stage({}, vk::ShaderStageFlagBits::eCompute,
                                                      *module, "main", &specialization);
        pipeline_ =
            handle.createComputePipeline(device.pipelineCache().handle(), {{}, stage, *layout_});
        device.pipelineCache().store();
        device.setName(pipeline_, info.name);
    });
}

void ComputePipeline::run(const Device& device, uint32_t groups,
                          std::span<const std::byte> pushConstants) const {
    CALOTYPE_CHECK_LE(groups, device.limits().maxComputeWorkGroupCount[0]);
    device.submitAndWait([&](const vk::raii::CommandBuffer& commands) {
        commands.bindPipeline(vk::PipelineBindPoint::eCompute, *pipeline_);
        commands.bindDescriptorSets(vk::PipelineBindPoint::eCompute, *layout_, 0, set_, {});
        if (!pushConstants.empty())
            commands.pushConstants<std::byte>(
                *layout_, vk::ShaderStageFlagBits::eCompute, 0,
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
