#pragma once

#include "materials/material_kind.h"

namespace calotype {

/// MaterialType::Dielectric: a smooth boundary that reflects and refracts.
MaterialKind dielectricKind();

} // namespace calotype
