#pragma once

#include <cstdint>
#include <memory>
#include <utility>

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

/// Opens a device when it is first needed, and keeps it, with the kernels that it has compiled.
class DeviceKeeper {
public:
    explicit DeviceKeeper(DeviceOptions options) : options_(std::move(options)) {}

    const DeviceOptions& options() const { return options_; }

    /// Throws GpuError like DeviceSession.
    std::shared_ptr<const DeviceSession> session();

    /// The next call of `session` opens the device anew: after an error it may be of no use.
    void forget() { session_.reset(); }

private:
    DeviceOptions options_;
    std::shared_ptr<const DeviceSession> session_;
};

/// Throws GpuError with the estimate and the limit if `bytes` exceed the device's memory.
void requireMemory(const Device& device, uint64_t bytes);

} // namespace calotype
