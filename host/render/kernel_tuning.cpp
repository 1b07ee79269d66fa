#include "render/kernel_tuning.h"

namespace calotype {

KernelTuning tuningFor(const DeviceInfo& device) {
    KernelTuning tuning;
    tuning.sharesStack = device.type != "CPU";
    return tuning;
}

} // namespace calotype
