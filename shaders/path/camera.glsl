// Camera rays.
#ifndef CALOTYPE_PATH_CAMERA_GLSL
#define CALOTYPE_PATH_CAMERA_GLSL

#include "config/features.glsl"
#include "core/constants.glsl"
#include "core/ray.glsl"
#include "core/warp.glsl"
#include "shared/scene_structs.h"

/// The ray through a position on the film, in pixels from the top left corner, and a point on the
/// lens that `u` chooses. All rays of a position meet in the plane of focus. Unit direction.
Ray cameraRay(Camera camera, vec2 filmPosition, uvec2 imageSize, vec2 u) {
    vec2 ndc = 2.0 * filmPosition / vec2(imageSize) - 1.0;
    vec3 onPlane = ndc.x * camera.right - ndc.y * camera.up;
    bool orthographic = hasOrthographic && camera.isOrthographic != 0u;
    vec3 origin = orthographic ? camera.position + onPlane : camera.position;
    vec3 direction = orthographic ? camera.forward : camera.forward + onPlane;
    if (hasLens) {
        vec2 p = warpToDisk(u);
        vec3 onLens = p.x * camera.lensRight + p.y * camera.lensUp;
        origin += onLens;
        direction -= onLens / camera.focusDistance;
    }
    return Ray(origin, kFar, normalize(direction));
}

#endif
