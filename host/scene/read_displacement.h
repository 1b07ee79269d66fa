#pragma once

#include "scene/displacement.h"
#include "scene/load_context.h"

namespace calotype {

/// The "displacement" of a mesh or a material.
Displacement readDisplacement(const JsonValue& value, const LoadContext& context);

} // namespace calotype
