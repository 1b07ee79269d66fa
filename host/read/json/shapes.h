#pragma once

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// An element of the scene file's "shapes".
JsonType shapeType();

/// Reads the scene file's "shapes" into Scene::shapes.
void readShapes(const JsonValue& value, JsonContext& context);

} // namespace calotype
