#pragma once

#include <nlohmann/json_fwd.hpp>

#include "read/load.h"

namespace calotype {

/// Sets the value at the override's pointer, which may be new; "-" appends to an array. Throws
/// SceneError at "--set POINTER" if the pointer is malformed or its parent does not exist.
void applyOverride(nlohmann::json& document, const SceneOverride& override);

/// Sets the keys of the document's "camera" that the options name. Throws SceneError if the camera
/// is placed by a matrix, which only a position and a target together can replace.
void applyView(nlohmann::json& document, const ViewOptions& view);

} // namespace calotype
