#pragma once

#include <cstddef>

#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// An element of the scene file's "lights".
JsonType lightType();

/// Element `index` of the scene file's "lights": a shape with its own black, emitting material,
/// which is added to Scene::materials as "light INDEX".
Shape readLight(const JsonValue& value, size_t index, JsonContext& context);

} // namespace calotype
