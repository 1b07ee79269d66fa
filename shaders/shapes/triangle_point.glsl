// The normal of a triangle, and how well a point on it is known.
#ifndef CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_POINT_GLSL

#include "core/rounding.glsl"
#include "core/select.glsl"

/// A triangle's plane, whatever its size: the edges are scaled to about one first, so that their
/// product neither underflows nor overflows.
struct TrianglePlane {
    vec3 normal;     ///< unit length
    float scale;     ///< 1 / the largest component of the two edges
    float thickness; ///< the least of the scaled triangle's heights
};

TrianglePlane trianglePlane(vec3 edge1, vec3 edge2) {
    float scale = 1.0 / greatest(max(abs(edge1), abs(edge2)));
    vec3 a = edge1 * scale;
    vec3 b = edge2 * scale;
    vec3 product = cross(a, b);
    float area = length(product);
    float longest = sqrt(greatest(vec3(dot(a, a), dot(b, b), dot(b - a, b - a))));
    return TrianglePlane(product / area, scale, area / longest);
}

/// Weights of a point that is off the edges by eight roundings of the triangle's coordinates, so
/// that, moved off the triangle by its error, it is still on the inner side of a neighbour that
/// stands there at an angle: else one ray in some millions leaves a closed mesh through an edge.
/// Triangles so thin or so far that this would move the point visibly keep theirs.
vec2 weightsOffEdges(vec2 b, vec3 v0, TrianglePlane plane) {
    float smallest = GAMMA(8.0) * (greatest(abs(v0)) * plane.scale + 1.0) / plane.thickness;
    vec2 moved = greater(b, vec2(smallest));
    moved *= lesser((1.0 - smallest) / (moved.x + moved.y), 1.0);
    return smallest < 0.015625 ? moved : b;
}

/// Bound on the distance along the normal between the plane and p = v0 + (along1 + along2), where
/// along_i is a barycentric weight times an edge: the edges' differences, the products and their
/// sum are off by gamma_3 of themselves at most, doubled for the rounding of the normal, and the
/// last sum by the rounding of p (PBR, 4th edition, section 6.8.5, has the same argument).
float triangleError(vec3 p, vec3 along1, vec3 along2, vec3 normal) {
    return dot(abs(normal), GAMMA(6.0) * (abs(along1) + abs(along2)) + GAMMA(2.0) * abs(p));
}

#endif
