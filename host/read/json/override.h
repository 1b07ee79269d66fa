#pragma once

#include <nlohmann/json_fwd.hpp>

#include "read/load.h"

namespace calotype {

/// Sets what the override's pointer names, in place or anew; "-" appends to an array. Throws
/// SceneError at "--set POINTER" where the pointer is malformed or what contains it is missing.
void applyOverride(nlohmann::json& document, const SceneOverride& override);

} // namespace calotype
