// From the unit square to disks, triangles, spheres, hemispheres and cones of directions.
#ifndef CALOTYPE_CORE_WARP_GLSL
#define CALOTYPE_CORE_WARP_GLSL

#include "core/constants.glsl"
#include "core/trigonometry.glsl"

/// Uniform on the unit disk: r = sqrt(u.x), phi = 2 pi u.y. Density 1 / pi.
vec2 warpToDisk(vec2 u) {
    vec2 sinCos = sinCosTwoPi(u.y);
    return sqrt(u.x) * sinCos.yx;
}

/// Barycentric weights of the second and third corner, uniform on a triangle's area
/// (docs/models.md, "Triangle light").
vec2 warpToTriangle(vec2 u) {
    float root = sqrt(u.x);
    return vec2(root * (1.0 - u.y), root * u.y);
}

/// Uniform on the unit sphere. Density 1 / (4 pi).
vec3 warpToSphere(vec2 u) {
    float z = 1.0 - 2.0 * u.x;
    float sinTheta = 2.0 * sqrt(u.x * (1.0 - u.x));
    vec2 sinCosPhi = sinCosTwoPi(u.y);
    return vec3(sinTheta * sinCosPhi.y, sinTheta * sinCosPhi.x, z);
}

/// Cosine-weighted about +z, by Malley's method (docs/models.md, "Lambert"). z > 0 for every u in
/// [0, 1).
vec3 warpToCosineHemisphere(vec2 u) { return vec3(warpToDisk(u), sqrt(1.0 - u.x)); }

/// Density of warpToCosineHemisphere, per solid angle.
float cosineHemispherePdf(float cosTheta) { return cosTheta * kInvPi; }

#endif
