// Camera rays.
#ifndef CALOTYPE_PATH_CAMERA_GLSL
#define CALOTYPE_PATH_CAMERA_GLSL

#include "core/constants.glsl"
#include "core/ray.glsl"
#include "shared/scene_structs.h"

/// Ray through a position on the film, in pixels from the top left corner. Unit direction.
Ray cameraRay(Camera camera, vec2 filmPosition, uvec2 imageSize) {
    vec2 ndc = 2.0 * filmPosition / vec2(imageSize) - 1.0;
    vec3 direction = camera.forward + ndc.x * camera.right - ndc.y * camera.up;
    return Ray(camera.position, kFar, normalize(direction));
}

#endif
