#pragma once

#include <utility>

#define VULKAN_HPP_NO_SPACESHIP_OPERATOR
#include <vulkan/vulkan_raii.hpp>

#include "base/error.h"

namespace calotype {

/// Runs `call`. If the driver fails, throws a GpuError that names the Vulkan function and its
/// result.
template <typename Call>
decltype(auto) callVulkan(Call&& call) {
    try {
        return std::forward<Call>(call)();
    } catch (const vk::DeviceLostError& error) {
        throw GpuError(std::string("the device was lost (") + error.what() +
                       "): its driver ends work that runs too long or fails; try again with a "
                       "smaller --size or another --device");
    } catch (const vk::OutOfDeviceMemoryError& error) {
        throw GpuError(std::string("the device is out of memory (") + error.what() + ")");
    } catch (const vk::SystemError& error) {
        throw GpuError(std::string("the driver reports ") + error.what());
    }
}

} // namespace calotype
