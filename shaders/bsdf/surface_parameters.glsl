// A material's parameters at a point of a surface, after its textures are looked up.
#ifndef CALOTYPE_BSDF_SURFACE_PARAMETERS_GLSL
#define CALOTYPE_BSDF_SURFACE_PARAMETERS_GLSL

#include "config/features.glsl"
#include "shared/scene_structs.h"

/// The fields are those of Material. The lobes get another `eta`: the index of refraction on the
/// far side over that on the viewer's side.
struct SurfaceParameters {
    uint lobes;
    vec3 color;
    float roughness;
    float specular;
    float kd;
    float exponent;
    float eta;
};

/// The colour of the material's lobes: a metal's F0, the reflectance of any other opaque material,
/// 1 for a clear one.
vec3 surfaceAlbedo(SurfaceParameters surface) {
    return (surface.lobes & kColorIsTint) != 0u ? vec3(1.0) : surface.color;
}

#endif
