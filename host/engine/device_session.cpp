#include "engine/device_session.h"

#include <string>

#include "base/error.h"

namespace calotype {

DeviceSession::DeviceSession(const DeviceOptions& options)
    : instance_(options.validates),
      device_(instance_, options.device, options.askedBy, options.cacheFolder) {}

void DeviceSession::throwOnValidationMessages() const {
    const auto messages = instance_.validationMessages();
    if (!messages.empty())
        throw GpuError("the validation layers have " + std::to_string(messages.size()) +
                       " messages, the first: " + messages.front());
}

std::shared_ptr<const DeviceSession> DeviceKeeper::session() {
    if (!session_)
        session_ = std::make_shared<const DeviceSession>(options_);
    return session_;
}

void requireMemory(const Device& device, uint64_t bytes) {
    if (bytes > device.info().memoryBytes)
        throw GpuError("the scene and picture need about " + std::to_string(bytes >> 20) +
                       " MiB on the device, and '" + device.info().name + "' has " +
                       std::to_string(device.info().memoryBytes >> 20) + " MiB");
}

} // namespace calotype
