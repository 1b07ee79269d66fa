// The normal of a triangle, and how well a point on it is known.
#ifndef CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL

#include "core/rounding.glsl"

/// Unit normal of a triangle, whatever its size: the edges are scaled to about one first, so that
/// their product neither underflows nor overflows.
vec3 triangleNormal(vec3 edge1, vec3 edge2) {
    vec3 magnitude = max(abs(edge1), abs(edge2));
    float scale = 1.0 / max(max(magnitude.x, magnitude.y), magnitude.z);
    return normalize(cross(edge1 * scale, edge2 * scale));
}

/// Bound on the distance along the normal between the plane and p = v0 + (along1 + along2), where
/// along_i is a barycentric weight times an edge: the edges' differences, the products and their
/// sum are off by gamma_3 of themselves at most, doubled for the rounding of the normal, and the
/// last sum by the rounding of p (PBR, 4th edition, section 6.8.5, has the same argument).
float triangleError(vec3 p, vec3 along1, vec3 along2, vec3 normal) {
    return dot(abs(normal), GAMMA(6.0) * (abs(along1) + abs(along2)) + GAMMA(2.0) * abs(p));
}

#endif
