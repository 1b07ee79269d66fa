#pragma once

#include <cstddef>
#include <string>

#include "read/json/object.h"

namespace calotype {

/// The key "name" of shapes and lights.
JsonKey objectNameKey();

/// Its text; without the key `kind` and the index, as in "sphere 3". Throws SceneError if it is
/// empty.
std::string readObjectName(const JsonObject& object, const std::string& kind, size_t index);

} // namespace calotype
