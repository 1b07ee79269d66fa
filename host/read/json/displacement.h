#pragma once

#include "mesh/displacement.h"
#include "read/load_context.h"

namespace calotype {

/// The "displacement" of a mesh or a material.
Displacement readDisplacement(const JsonValue& value, const LoadContext& context);

} // namespace calotype
