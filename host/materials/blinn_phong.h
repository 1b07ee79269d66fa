#pragma once

#include "materials/material_kind.h"

namespace calotype {

/// MaterialType::BlinnPhong: a half-vector Blinn-Phong lobe over a diffuse one.
MaterialKind blinnPhongKind();

} // namespace calotype
