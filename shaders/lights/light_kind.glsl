// What kind of light a light is. A kernel that has only one kind of lights does not read
// Light.kind.
#ifndef CALOTYPE_LIGHTS_LIGHT_KIND_GLSL
#define CALOTYPE_LIGHTS_LIGHT_KIND_GLSL

#include "config/features.glsl"
#include "shared/scene_structs.h"

bool isInfiniteLight(Light light) {
    return hasInfiniteLights && (!hasFiniteLights || sortOfLight(light.kind) == kSortInfinite);
}

/// The light is not infinite.
bool isUniformQuadricLight(Light light) {
    return hasUniformQuadricLights &&
           (kAreaKinds == 0u || sortOfLight(light.kind) == kSortUniformQuadric);
}

/// Whether the light has that kind. `isPresent`: the kernel has lights of the kind. `isAlone`: it
/// has no other kind of the same sort. The light has that sort.
bool isOfKind(Light light, uint kind, bool isPresent, bool isAlone) {
    return isPresent && (isAlone || light.kind == kind);
}

#endif
