#pragma once

#include <string>

#include "materials/material_kind.h"

namespace calotype {

/// "color": a reflectance or a texture; required.
MaterialParameter texturedColor(const std::string& description);

/// "roughness" and "masking" of a GGX lobe.
MaterialParameter roughnessParameter();
MaterialParameter maskingParameter();

/// "emission" and "emission_side" of an opaque material.
MaterialParameter emissionParameter();
MaterialParameter emissionSideParameter();

} // namespace calotype
