// The closed list of lobes: their files, and properties of some of them. Code outside the files
// depends on these constants, not on a certain lobe.
#ifndef CALOTYPE_BSDF_LOBES_GLSL
#define CALOTYPE_BSDF_LOBES_GLSL

#include "bsdf/blinn_phong.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/ggx.glsl"
#include "config/features.glsl"

/// True if some lobe may be specular.
const bool hasSpecular = hasMirrors || hasDielectric;
/// True if some lobe transmits and has a density: then light is also sampled from the far side.
const bool hasTransmission = false;
/// True if some lobe transmits, with a density or without.
const bool hasCrossing = hasDielectric || hasTransmission;

#endif
