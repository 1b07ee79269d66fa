#include "cli/device_environment.h"

#include <cstdlib>
#include <string>
#include <string_view>

#include "base/error.h"
#include "cli/denoiser_library.h"
#include "engine/devices.h"

namespace calotype {
namespace {

/// Empty if it is not set.
std::string variable(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

} // namespace

DeviceOptions withEnvironment(DeviceOptions options, bool knowsReference) {
    options.askedBy = "--device";
    if (!knowsReference && isReference(options))
        throw UsageError("--device reference is no device; only render and study support it");
    if (options.device.empty()) {
        options.askedBy = "CALOTYPE_DEVICE";
        options.device = variable("CALOTYPE_DEVICE");
        if (!knowsReference && isReference(options))
            options.device.clear();
    }
    options.denoiserLibrary = denoiserLibrary();
    const std::string validation = variable("CALOTYPE_VALIDATION");
    options.validates = !validation.empty() && validation != "0";
    if (options.threads > 0 && !isReference(options))
        setenv("LP_NUM_THREADS", std::to_string(options.threads).c_str(), 1);
    return options;
}

} // namespace calotype
