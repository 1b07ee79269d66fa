#pragma once

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// An element of the scene file's "shapes".
JsonType shapeType();
/// `index` is that in the list of shapes, for the default of its name.
Shape readShape(const JsonValue& value, size_t index, JsonContext& context);

} // namespace calotype
