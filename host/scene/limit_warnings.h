#pragma once

#include <string>

#include "scene/load_context.h"

namespace calotype {

/// Warns, once all is read, of what the device's single precision and fixed point do not hold well.
/// `path` is the scene file's or the model's.
void warnOfLimits(LoadContext& context, const std::string& path);

} // namespace calotype
