#include "gpu/device.h"

#include <algorithm>

#include "gpu/choose_device.h"
#include "gpu/device_list.h"

namespace calotype {
namespace {

uint32_t computeFamily(const vk::raii::PhysicalDevice& physicalDevice) {
    const auto families = physicalDevice.getQueueFamilyProperties();
    const auto family = std::find_if(families.begin(), families.end(), [](const auto& properties) {
        return static_cast<bool>(properties.queueFlags & vk::QueueFlagBits::eCompute);
    });
    return static_cast<uint32_t>(family - families.begin());
}

} // namespace

Device::Device(const Instance& instance, std::string_view wish, std::string_view askedBy,
               const std::filesystem::path& cacheFolder) {
    const auto devices = listDevices(instance);
    choice_ = chooseDevice(devices, wish, askedBy);
    info_ = devices[choice_.index];
    callVulkan([&] {
        const auto physicalDevices = instance.handle().enumeratePhysicalDevices();
        const vk::raii::PhysicalDevice& physicalDevice = physicalDevices[choice_.index];
        limits_ = physicalDevice.getProperties().limits;
        memory_ = physicalDevice.getMemoryProperties();
        const uint32_t family = computeFamily(physicalDevice);
        const float priority = 1.0f;
        const vk::DeviceQueueCreateInfo queueInfo({}, family, 1, &priority);
        device_ = physicalDevice.createDevice(vk::DeviceCreateInfo({}, queueInfo));
        namesObjects_ = device_.getDispatcher()->vkSetDebugUtilsObjectNameEXT != nullptr;
        pipelineCache_ =
            std::make_unique<PipelineCache>(physicalDevice.getProperties(), device_, cacheFolder);
        queue_ = device_.getQueue(family, 0);
        commandPool_ =
            device_.createCommandPool({vk::CommandPoolCreateFlagBits::eResetCommandBuffer, family});
        commandBuffer_ = std::move(device_.allocateCommandBuffers(
            {*commandPool_, vk::CommandBufferLevel::ePrimary, 1})[0]);
        fence_ = device_.createFence({});
    });
}

uint32_t Device::memoryType(uint32_t allowed, vk::MemoryPropertyFlags wanted) const {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
        if ((allowed & (1u << i)) != 0 && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted)
            return i;
    throw GpuError("the device has no memory that is " + vk::to_string(wanted));
}

void Device::submitAndWait(
    const std::function<void(const vk::raii::CommandBuffer&)>& record) const {
    callVulkan([&] {
        commandBuffer_.begin({vk::CommandBufferUsageFlagBits::eOneTimeSubmit});
        record(commandBuffer_);
        commandBuffer_.end();
        queue_.submit(vk::SubmitInfo({}, {}, *commandBuffer_), *fence_);
        const auto forever = UINT64_MAX;
        if (device_.waitForFences(*fence_, true, forever) != vk::Result::eSuccess)
            throw GpuError("the device did not finish its work");
        device_.resetFences(*fence_);
    });
}

} // namespace calotype
