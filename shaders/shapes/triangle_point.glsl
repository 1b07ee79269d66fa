// The normal of a triangle, and how well a point on it is known.
#ifndef CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL

#include "core/rounding.glsl"
#include "shared/scene_structs.h"

vec3 normalOf(Triangle triangle) {
    return vec3(triangle.normalX, triangle.normalY, triangle.normalZ);
}

/// Bound on the distance along the normal between the plane and p = v0 + (along1 + along2), where
/// along_i is a barycentric weight times an edge: the edges' differences, the products and their
/// sum are off by gamma_3 of themselves at most, doubled for the rounding of the normal, and the
/// last sum by the rounding of p (PBR, 4th edition, section 6.8.5, has the same argument).
float triangleError(vec3 p, vec3 along1, vec3 along2, vec3 normal) {
    return dot(abs(normal), GAMMA(6.0) * (abs(along1) + abs(along2)) + GAMMA(2.0) * abs(p));
}

#endif
