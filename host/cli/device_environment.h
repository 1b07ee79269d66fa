#pragma once

#include "settings/device_options.h"

namespace calotype {

/// The device that the options name, or else the environment variable CALOTYPE_DEVICE, and whether
/// CALOTYPE_VALIDATION asks for the validation layers. Where lavapipe's number of threads is given,
/// its environment variable is set, so this has to be called before Vulkan is used. Throws
/// UsageError where the options name the reference tracer, and the command does not know it; the
/// variable's "reference" then means no device in particular.
DeviceOptions withEnvironment(DeviceOptions options, bool knowsReference);

} // namespace calotype
