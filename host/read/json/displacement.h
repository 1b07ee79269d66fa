#pragma once

#include "mesh/displacement.h"
#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The key "displacement" of meshes and materials.
JsonKey displacementKey();

/// The "displacement" of a mesh or a material.
Displacement readDisplacement(const JsonValue& value, const JsonContext& context);

} // namespace calotype
