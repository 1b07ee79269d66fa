#pragma once

#include "materials/material_kind.h"

namespace calotype {

/// MaterialType::Nonmetal: a GGX lobe over a diffuse one.
MaterialKind nonmetalKind();

} // namespace calotype
