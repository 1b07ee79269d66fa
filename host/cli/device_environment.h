#pragma once

#include "settings/device_options.h"

namespace calotype {

/// Adds the environment to the options: CALOTYPE_DEVICE is the device if the options name none;
/// CALOTYPE_VALIDATION turns on the validation layers. If lavapipe's number of threads is given,
/// sets its environment variable, so call this before Vulkan is used. If the command does not
/// support the reference tracer, throws UsageError if the options name it, and ignores it in the
/// variable.
DeviceOptions withEnvironment(DeviceOptions options, bool knowsReference);

} // namespace calotype
