#pragma once

#include "read/load_context.h"

namespace calotype {

/// Element `index` of the scene file's "lights": a shape that bears a black, emitting material of
/// its own, which is added to Scene::materials as "light INDEX".
Shape readLight(const JsonValue& value, size_t index, LoadContext& context);

} // namespace calotype
