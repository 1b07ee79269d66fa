// The closed list of lobes: their files, and what some of them do. Code outside their files rests
// on these constants, not on which lobe it is that does so.
#ifndef CALOTYPE_BSDF_LOBES_GLSL
#define CALOTYPE_BSDF_LOBES_GLSL

#include "bsdf/blinn_phong.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/ggx.glsl"
#include "config/features.glsl"

/// Some lobe may be specular.
const bool hasSpecular = hasMirrors || hasDielectric;
/// Some lobe transmits and has a density, so that light samples from the far side count: none yet.
const bool hasTransmission = false;
/// Some lobe transmits, with a density or without.
const bool hasCrossing = hasDielectric || hasTransmission;

#endif
