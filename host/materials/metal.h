#pragma once

#include "materials/material_kind.h"

namespace calotype {

/// MaterialType::Metal: a GGX lobe whose F0 is the colour.
MaterialKind metalKind();

} // namespace calotype
