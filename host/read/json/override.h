#pragma once

#include <nlohmann/json_fwd.hpp>

#include "read/load.h"

namespace calotype {

/// Sets the value at the override's pointer, which may be new; "-" appends to an array. Throws
/// SceneError at "--set POINTER" if the pointer is malformed or its parent does not exist.
void applyOverride(nlohmann::json& document, const SceneOverride& override);

} // namespace calotype
