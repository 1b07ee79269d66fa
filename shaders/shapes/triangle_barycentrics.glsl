// Where on a triangle a ray meets it.
//
// The barycentric weights are the edge functions over their sum. The products of the edge functions
// are rounded relative to the corners' distances from the ray, which for a sliver outweighs its
// area, and its hits would be strewn along it. So the products are taken without error here. What
// is left is the rounding of the sheared corners, a shift by some 2^-22 of their distances.
#ifndef CALOTYPE_SHAPES_TRIANGLE_BARYCENTRICS_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_BARYCENTRICS_GLSL

#include "core/error_free.glsl"
#include "shapes/triangle.glsl"

/// Weights of the ends of the longest of the projected edges for the point of it that is nearest to
/// the ray: what is left where the projection has no area.
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

/// Weights of the second and third corner at a hit; each in [0, 1], and so is what they leave.
vec2 triangleBarycentrics(ShearedRay ray, Triangle triangle) {
    ShearedTriangle seen = shearTriangle(ray, triangle);
    vec3 e = vec3(differenceOfProducts(seen.c.x, seen.b.y, seen.c.y, seen.b.x),
                  differenceOfProducts(seen.a.x, seen.c.y, seen.a.y, seen.c.x),
                  differenceOfProducts(seen.b.x, seen.a.y, seen.b.y, seen.a.x));
    // The accepted hit's are of one sign but for what rounding zeroed, which may have had the
    // other.
    e = e.x + e.y + e.z < 0.0 ? -e : e;
    e = greater(e, vec3(0.0));
    float sum = e.x + e.y + e.z;
    vec3 weights = sum > 0.0 ? e / sum : weightsOnLongestEdge(seen);
    return weights.yz;
}

#endif
