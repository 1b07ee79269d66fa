// The shadow terminator: a smooth normal bends light around a flat triangle, whose plane cuts it
// off in steps. Rays leave instead from a curved patch through the corners, perpendicular there to
// the corners' normals: the mean, by barycentric weights, of the point's projections onto the
// tangent planes at the corners (Hanika 2021, "Hacking the Shadow Terminator", Ray Tracing Gems II,
// chapter 4). Where the surface is concave, or flat, the patch is the triangle.
//
// The patch stands off the triangle by its sagitta. What touches a coarse mesh within that distance
// does not shadow it: finer meshes, or flat normals, keep such contacts dark.
#ifndef CALOTYPE_SHAPES_TERMINATOR_GLSL
#define CALOTYPE_SHAPES_TERMINATOR_GLSL

#include "core/select.glsl"
#include "shared/scene_structs.h"

/// From the point p of the triangle to the patch. `side` turns the corners' normals to the side
/// from which light leaves: 1 or -1.
vec3 terminatorOffset(Triangle triangle, TriangleNormals normals, vec3 p, vec2 barycentrics,
                      float side) {
    float depth0 = lesser(side * dot(p - triangle.v0, normals.n0), 0.0);
    float depth1 = lesser(side * dot(p - triangle.v1, normals.n1), 0.0);
    float depth2 = lesser(side * dot(p - triangle.v2, normals.n2), 0.0);
    return -side * ((1.0 - barycentrics.x - barycentrics.y) * depth0 * normals.n0 +
                    barycentrics.x * depth1 * normals.n1 + barycentrics.y * depth2 * normals.n2);
}

#endif
