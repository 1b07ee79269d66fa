// The barycentric coordinates of a hit on a triangle.
//
// The barycentric weights are the edge functions over their sum. Rounding of their products is
// relative to the corners' distances from the ray, which for a sliver exceeds its area: hits would
// be scattered along it. So the products are computed without error here. What remains is the
// rounding of the sheared corners, a shift by about 2^-22 of their distances.
#ifndef CALOTYPE_SHAPES_TRIANGLE_BARYCENTRICS_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_BARYCENTRICS_GLSL

#include "core/error_free.glsl"
#include "shapes/triangle.glsl"

/// For a projection without area: the weights of the point nearest to the ray on the longest of the
/// projected edges.
vec3 weightsOnLongestEdge(ShearedTriangle seen) {
    float ab = dot(seen.b - seen.a, seen.b - seen.a);
    float bc = dot(seen.c - seen.b, seen.c - seen.b);
    float ca = dot(seen.a - seen.c, seen.a - seen.c);
    bool isAb = ab >= bc && ab >= ca;
    bool isBc = !isAb && bc >= ca;
    vec2 from = isAb ? seen.a : isBc ? seen.b : seen.c;
    vec2 edge = (isAb ? seen.b : isBc ? seen.c : seen.a) - from;
    float square = dot(edge, edge);
    float along = square > 0.0 ? clamp(-dot(from, edge) / square, 0.0, 1.0) : 0.0;
    vec3 weights = vec3(1.0 - along, along, 0.0);
    return isAb ? weights : isBc ? weights.zxy : weights.yzx;
}

/// Weights of the second and third corner at a hit; each is in [0, 1], and so is their sum.
vec2 triangleBarycentrics(ShearedRay ray, Triangle triangle) {
    ShearedTriangle seen = shearTriangle(ray, triangle);
    vec3 e = vec3(differenceOfProducts(seen.c.x, seen.b.y, seen.c.y, seen.b.x),
                  differenceOfProducts(seen.a.x, seen.c.y, seen.a.y, seen.c.x),
                  differenceOfProducts(seen.b.x, seen.a.y, seen.b.y, seen.a.x));
    // For an accepted hit all have the same sign, except those that were rounded to zero there:
    // these may have the other one.
    e = e.x + e.y + e.z < 0.0 ? -e : e;
    e = greater(e, vec3(0.0));
    float sum = e.x + e.y + e.z;
    vec3 weights = sum > 0.0 ? e / sum : weightsOnLongestEdge(seen);
    return weights.yz;
}

#endif
