#include "gpu/instance.h"

#include <algorithm>
#include <cstring>
#include <stdexcept>

namespace calotype {
namespace {

constexpr const char* kValidationLayer = "VK_LAYER_KHRONOS_validation";

void requireValidationLayer(const vk::raii::Context& context) {
    const auto layers = context.enumerateInstanceLayerProperties();
    if (std::none_of(layers.begin(), layers.end(), [](const vk::LayerProperties& layer) {
            return std::strcmp(layer.layerName, kValidationLayer) == 0;
        }))
        throw GpuError("validation is wanted, but the Khronos validation layer is not "
                       "installed (Debian: vulkan-validationlayers)");
}

vk::raii::Context loadVulkan() {
    try {
        return {};
    } catch (const std::runtime_error&) {
        throw GpuError("the Vulkan loader is not installed (Debian: libvulkan1)");
    }
}

vk::raii::Instance createInstance(const vk::raii::Context& context,
                                  const vk::InstanceCreateInfo& info) {
    try {
        return context.createInstance(info);
    } catch (const vk::IncompatibleDriverError&) {
        throw GpuError("there is no Vulkan driver; install one (Debian: mesa-vulkan-drivers, which "
                       "renders on the CPU)");
    }
}

} // namespace

VkBool32 Instance::onValidationMessage(VkDebugUtilsMessageSeverityFlagBitsEXT,
                                       VkDebugUtilsMessageTypeFlagsEXT,
                                       const VkDebugUtilsMessengerCallbackDataEXT* data,
                                       void* log) {
    auto& messageLog = *static_cast<MessageLog*>(log);
    const std::lock_guard lock(messageLog.mutex);
    messageLog.messages.emplace_back(data->pMessage);
    return VK_FALSE;
}

Instance::Instance(bool validates) : log_(std::make_unique<MessageLog>()), context_(loadVulkan()) {
    callVulkan([&] {
        if (validates)
            requireValidationLayer(context_);
        const vk::ApplicationInfo application("calotype", 1, "calotype", 1, VK_API_VERSION_1_2);
        const std::vector<const char*> layers(validates ? 1 : 0, kValidationLayer);
        const std::vector<const char*> extensions(validates ? 1 : 0,
                                                  VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
        instance_ = createInstance(context_, {{}, &application, layers, extensions});
        if (!validates)
            return;
        using Severity = vk::DebugUtilsMessageSeverityFlagBitsEXT;
        using Type = vk::DebugUtilsMessageTypeFlagBitsEXT;
        messenger_ = instance_.createDebugUtilsMessengerEXT(vk::DebugUtilsMessengerCreateInfoEXT(
            {}, Severity::eWarning | Severity::eError, Type::eGeneral | Type::eValidation,
            &onValidationMessage, log_.get()));
    });
}

std::vector<std::string> Instance::validationMessages() const {
    const std::lock_guard lock(log_->mutex);
    return log_->messages;
}

} // namespace calotype
