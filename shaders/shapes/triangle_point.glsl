// The normal of a triangle, and the error bound of a point on it.
#ifndef CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL

#include "core/rounding.glsl"
#include "shared/scene_structs.h"

vec3 normalOf(Triangle triangle) {
    return vec3(triangle.normalX, triangle.normalY, triangle.normalZ);
}

/// Bound on the distance along the normal between the plane and p = v0 + (along1 + along2), where
/// along_i is a barycentric weight times an edge: differences, products and their sum have an error
/// of gamma_3 at most, relative to themselves, doubled for the rounding of the normal; the last sum
/// adds the rounding of p (the same argument is in PBR, 4th edition, section 6.8.5).
float triangleError(vec3 p, vec3 along1, vec3 along2, vec3 normal) {
    return dot(abs(normal), GAMMA(6.0) * (abs(along1) + abs(along2)) + GAMMA(2.0) * abs(p));
}

#endif
