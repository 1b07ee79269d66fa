#pragma once

#include <cstdint>

#include "gpu/device.h"
#include "gpu/instance.h"
#include "settings/device_options.h"

namespace calotype {

/// Vulkan and the device that the options name.
class DeviceSession {
public:
    /// Throws GpuError if there is no such device, or if it does not support what Calotype needs.
    explicit DeviceSession(const DeviceOptions& options);

    const Device& device() const { return device_; }

    /// Throws GpuError with the first message of the validation layers, if there is any.
    void throwOnValidationMessages() const;

private:
    Instance instance_;
    Device device_;
};

/// Throws GpuError with the estimate and the limit if `bytes` exceed the device's memory.
void requireMemory(const Device& device, uint64_t bytes);

} // namespace calotype
