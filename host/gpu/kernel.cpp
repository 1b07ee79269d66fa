#include "gpu/kernel.h"

#include <algorithm>
#include <string_view>

#include "base/content_hash.h"
#include "gpu/device.h"

namespace calotype {
namespace {

/// A hash of all that the compiled kernel depends on.
uint64_t keyOf(const KernelInfo& info) {
    ContentHash hash;
    const auto add = [&](const void* data, size_t bytes) {
        hash.add({static_cast<const char*>(data), bytes});
    };
    add(info.spirv.data(), info.spirv.size_bytes());
    for (const vk::DescriptorSetLayoutBinding& binding : info.bindings) {
        add(&binding.binding, sizeof binding.binding);
        add(&binding.descriptorType, sizeof binding.descriptorType);
        add(&binding.descriptorCount, sizeof binding.descriptorCount);
        add(&binding.stageFlags, sizeof binding.stageFlags);
    }
    add(info.constants.data(), info.constants.size() * sizeof(uint32_t));
    add(&info.pushConstantBytes, sizeof info.pushConstantBytes);
    return hash.value();
}

} // namespace

Kernel::Kernel(const Device& device, const KernelInfo& info) {
    callVulkan([&] {
        const auto& handle = device.handle();
        setLayout_ = handle.createDescriptorSetLayout({{}, info.bindings});
        const vk::PushConstantRange range(vk::ShaderStageFlagBits::eCompute, 0,
                                          info.pushConstantBytes);
        layout_ = handle.createPipelineLayout(
            {{}, 1, &*setLayout_, info.pushConstantBytes > 0 ? 1u : 0u, &range});
        std::vector<vk::SpecializationMapEntry> entries;
        for (uint32_t id = 0; id < info.constants.size(); ++id)
            entries.push_back({id, static_cast<uint32_t>(id * sizeof(uint32_t)), sizeof(uint32_t)});
        const vk::SpecializationInfo specialization(
            static_cast<uint32_t>(entries.size()), entries.data(),
            info.constants.size() * sizeof(uint32_t), info.constants.data());
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

std::shared_ptr<const Kernel> KernelStore::get(const Device& device, const KernelInfo& info) {
    const uint64_t key = keyOf(info);
    const auto known = std::ranges::find(entries_, key, &Entry::key);
    if (known != entries_.end()) {
        std::rotate(known, known + 1, entries_.end());
        return entries_.back().kernel;
    }
    const auto kernel = std::make_shared<const Kernel>(device, info);
    while (entries_.size() >= kMostKernels) {
        const auto unused = std::ranges::find_if(
            entries_, [](const Entry& entry) { return entry.kernel.use_count() == 1; });
        if (unused == entries_.end())
            break;
        entries_.erase(unused);
    }
    entries_.push_back({key, kernel});
    return kernel;
}

} // namespace calotype
