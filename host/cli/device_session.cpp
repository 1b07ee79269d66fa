#include "cli/device_session.h"

#include <cstdlib>
#include <string>

#include "base/error.h"
#include "base/lowercase.h"

namespace calotype {
namespace {

bool namesReference(const std::string& device) { return lowercase(device) == "reference"; }

} // namespace

bool isReference(const DeviceOptions& options) {
    const char* variable = std::getenv("CALOTYPE_DEVICE");
    return namesReference(options.device.empty() && variable ? variable : options.device);
}

Instance makeInstance(const DeviceOptions& options) {
    if (namesReference(options.device))
        throw UsageError("--device reference is no device; only render and study know it");
    if (options.threads > 0)
        setenv("LP_NUM_THREADS", std::to_string(options.threads).c_str(), 1);
    return Instance();
}

DeviceSession::DeviceSession(const DeviceOptions& options)
    : instance_(makeInstance(options)), device_(instance_, options.device) {}

void DeviceSession::throwOnValidationMessages() const {
    const auto messages = instance_.validationMessages();
    if (!messages.empty())
        throw GpuError("the validation layers have " + std::to_string(messages.size()) +
                       " messages, the first: " + messages.front());
}

void requireMemory(const Device& device, uint64_t bytes) {
    if (bytes > device.memorySize())
        throw GpuError("the scene and picture need about " + std::to_string(bytes >> 20) +
                       " MiB on the device, and '" + device.info().name + "' has " +
                       std::to_string(device.memorySize() >> 20) + " MiB");
}

} // namespace calotype
