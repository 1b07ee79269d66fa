#pragma once

#include "read/json/object.h"
#include "read/load_context.h"

namespace calotype {

/// An element of the scene file's "shapes".
JsonType shapeType();
Shape readShape(const JsonValue& value, LoadContext& context);

} // namespace calotype
