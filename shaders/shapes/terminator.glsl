// The shadow terminator: on a smooth mesh, the plane of each flat triangle cuts off light in
// visible steps. So rays start instead from a curved patch through the corners, perpendicular to
// the normals there: the mean, by barycentric weights, of the point's projections onto the tangent
// planes at the corners (Hanika 2021, "Hacking the Shadow Terminator", Ray Tracing Gems II, chapter
// 4). If the surface is concave or flat, the patch is the triangle.
//
// The distance from the triangle to the patch is its sagitta. An object that touches a coarse mesh
// casts no shadow within that distance: finer meshes, or flat normals, keep such contacts dark.
#ifndef CALOTYPE_SHAPES_TERMINATOR_GLSL
#define CALOTYPE_SHAPES_TERMINATOR_GLSL

#include "core/select.glsl"
#include "shared/scene_structs.h"

/// The vector from the point p of the triangle to the patch. `side` is 1 or -1: it turns the
/// corners' normals to the side from which light leaves.
vec3 terminatorOffset(Triangle triangle, TriangleNormals normals, vec3 p, vec2 barycentrics,
                      float side) {
    float depth0 = lesser(side * dot(p - triangle.v0, normals.n0), 0.0);
    float depth1 = lesser(side * dot(p - triangle.v1, normals.n1), 0.0);
    float depth2 = lesser(side * dot(p - triangle.v2, normals.n2), 0.0);
    return -side * ((1.0 - barycentrics.x - barycentrics.y) * depth0 * normals.n0 +
                    barycentrics.x * depth1 * normals.n1 + barycentrics.y * depth2 * normals.n2);
}

#endif
