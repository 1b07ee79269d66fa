#pragma once

#include "materials/material_kind.h"

namespace calotype {

/// MaterialType::Diffuse: a Lambertian surface.
MaterialKind diffuseKind();

} // namespace calotype
