#pragma once

#include "materials/material_kind.h"
#include "read/json/json_context.h"
#include "read/json/object.h"

namespace calotype {

/// The key of a material's parameter.
JsonKey keyOf(const MaterialParameter& parameter);

/// Sets the parameter of `material` from `object`, or to its default.
void readParameter(const MaterialParameter& parameter, const JsonObject& object,
                   const JsonContext& context, Material& material);

} // namespace calotype
