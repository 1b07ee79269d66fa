#pragma once

#include <cstdint>

#include "cli/options.h"
#include "gpu/device.h"
#include "gpu/instance.h"

namespace calotype {

/// Vulkan and the device that the options ask for.
class DeviceSession {
public:
    explicit DeviceSession(const DeviceOptions& options);

    const Device& device() const { return device_; }

    /// Throws GpuError with the first message of the validation layers, if there is any.
    void throwOnValidationMessages() const;

private:
    Instance instance_;
    Device device_;
};

/// Whether the options, or else CALOTYPE_DEVICE, ask for the reference tracer, on no device.
bool isReference(const DeviceOptions& options);

/// Instance after making sure that lavapipe will use as many threads as the options ask for: it
/// reads that when it is loaded. Throws UsageError where
/// --device names the reference.
Instance makeInstance(const DeviceOptions& options);

/// Throws GpuError with the estimate and the limit where `bytes` exceed the device's memory.
void requireMemory(const Device& device, uint64_t bytes);

} // namespace calotype
