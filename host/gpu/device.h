#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>

#include "gpu/device_info.h"
#include "gpu/instance.h"
#include "gpu/kernel.h"
#include "gpu/pipeline_cache.h"
#include "gpu/vulkan.h"

namespace calotype {

/// A logical device with one compute queue, used by one thread at a time.
class Device {
public:
    /// `cacheFolder` is that of PipelineCache. Throws GpuError like chooseDevice, or if the driver
    /// fails.
    Device(const Instance& instance, std::string_view wish, std::string_view askedBy = "",
           const std::filesystem::path& cacheFolder = {});

    const vk::raii::Device& handle() const { return device_; }
    const DeviceInfo& info() const { return info_; }
    const DeviceChoice& choice() const { return choice_; }
    const vk::PhysicalDeviceLimits& limits() const { return limits_; }

    PipelineCache& pipelineCache() const { return *pipelineCache_; }
    KernelStore& kernels() const { return *kernels_; }

    /// Index of a memory type among `allowed` (a bit mask) with all of `wanted`. Throws GpuError.
    uint32_t memoryType(uint32_t allowed, vk::MemoryPropertyFlags wanted) const;

    /// The properties of a memory type.
    vk::MemoryPropertyFlags memoryFlags(uint32_t type) const {
        return memory_.memoryTypes[type].propertyFlags;
    }

    /// Records commands, submits them and waits until they are done.
    void submitAndWait(const std::function<void(const vk::raii::CommandBuffer&)>& record) const;

    /// Gives an object the name that validation messages and debuggers show.
    template <typename Object>
    void setName(const Object& object, const std::string& name) const {
        if (namesObjects_)
            device_.setDebugUtilsObjectNameEXT(vk::DebugUtilsObjectNameInfoEXT(
                Object::objectType, uint64_t(static_cast<typename Object::CType>(*object)),
                name.c_str()));
    }

private:
    DeviceInfo info_;
    DeviceChoice choice_;
    bool namesObjects_ = false;
    vk::PhysicalDeviceLimits limits_;
    vk::PhysicalDeviceMemoryProperties memory_;
    vk::raii::Device device_ = nullptr;
    std::unique_ptr<PipelineCache> pipelineCache_;
    std::unique_ptr<KernelStore> kernels_ = std::make_unique<KernelStore>();
    vk::raii::Queue queue_ = nullptr;
    vk::raii::CommandPool commandPool_ = nullptr;
    vk::raii::CommandBuffer commandBuffer_ = nullptr;
    vk::raii::Fence fence_ = nullptr;
};

} // namespace calotype
