// The closed list of lobes: their files, and what some of them can do. Code outside the files
// depends on these constants, not on a certain lobe.
#ifndef CALOTYPE_BSDF_LOBES_GLSL
#define CALOTYPE_BSDF_LOBES_GLSL

#include "bsdf/blinn_phong.glsl"
#include "bsdf/dielectric.glsl"
#include "bsdf/diffuse.glsl"
#include "bsdf/ggx.glsl"

/// True if some lobe may be specular.
#define BEGIN_FEATURES const bool hasSpecular = false
#define LOBE(id, member, people) || k##id##MayBeSpecular
#define END_FEATURES ;
#include "shared/feature_table.h"

/// True if some lobe transmits, with a density or without.
#define BEGIN_FEATURES const bool hasCrossing = false
#define LOBE(id, member, people) || k##id##Crosses
#define END_FEATURES ;
#include "shared/feature_table.h"

/// True if some lobe transmits with a density: then light is also sampled from the far side.
#define BEGIN_FEATURES const bool hasTransmission = false
#define LOBE(id, member, people) || k##id##CrossesWithDensity
#define END_FEATURES ;
#include "shared/feature_table.h"

#endif
