// Constant radiance from everywhere: directions uniform on the sphere.
#ifndef CALOTYPE_LIGHTS_BACKGROUND_GLSL
#define CALOTYPE_LIGHTS_BACKGROUND_GLSL

#include "core/constants.glsl"
#include "core/trigonometry.glsl"

vec3 sampleBackground(vec2 u) {
    float z = 1.0 - 2.0 * u.x;
    float sinTheta = 2.0 * sqrt(u.x * (1.0 - u.x));
    vec2 sinCosPhi = sinCosTwoPi(u.y);
    return vec3(sinTheta * sinCosPhi.y, sinTheta * sinCosPhi.x, z);
}

/// Per solid angle.
const float kBackgroundPdf = 0.25 * kInvPi;

#endif
