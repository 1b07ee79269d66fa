#pragma once

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "gpu/vulkan.h"

namespace calotype {

/// The connection to Vulkan.
class Instance {
public:
    /// With `validates` the Khronos validation layer checks every call; its messages are stored,
    /// not printed. Throws GpuError if there is no Vulkan 1.2 loader, or no such layer.
    explicit Instance(bool validates = false);

    const vk::raii::Instance& handle() const { return instance_; }

    /// Warnings and errors of the validation layer so far.
    std::vector<std::string> validationMessages() const;

private:
    struct MessageLog {
        std::mutex mutex;
        std::vector<std::string> messages;
    };

    static VKAPI_ATTR VkBool32 VKAPI_CALL onValidationMessage(
        VkDebugUtilsMessageSeverityFlagBitsEXT severity, VkDebugUtilsMessageTypeFlagsEXT types,
        const VkDebugUtilsMessengerCallbackDataEXT* data, void* log);

    std::unique_ptr<MessageLog> log_; // outlives the messenger, which has a pointer to it
    vk::raii::Context context_;
    vk::raii::Instance instance_ = nullptr;
    vk::raii::DebugUtilsMessengerEXT messenger_ = nullptr;
};

} // namespace calotype
