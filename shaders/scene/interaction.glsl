// From a hit to what shading needs to know of the surface there.
#ifndef CALOTYPE_SCENE_INTERACTION_GLSL
#define CALOTYPE_SCENE_INTERACTION_GLSL

#include "scene/traversal.glsl"
#include "shapes/triangle_point.glsl"

struct Interaction {
    vec3 position;
    float error; ///< bound on the distance along ng between `position` and the true surface
    vec3 ng;     ///< unit geometric normal, outward
    vec3 ns;     ///< unit shading normal, on the side of ng
    uint material;
    uint light; ///< or kNone
    uint id;    ///< the primitive's number in the scene file
};

/// The point is taken from the barycentrics, the base corner added last: its error is relative to
/// the triangle, not to the length of the ray (Pharr, Jakob and Humphreys, PBR 3.9 and 6.8).
Interaction triangleInteraction(uint index, Ray ray) {
    Triangle triangle = loadTriangle(index);
    vec3 edge1 = triangle.v1 - triangle.v0;
    vec3 edge2 = triangle.v2 - triangle.v0;
    vec2 b = intersectTriangle(shearedRay(ray.origin, ray.direction), triangle.v0, triangle.v1,
                               triangle.v2)
                 .barycentrics;
    vec3 along1 = b.x * edge1;
    vec3 along2 = b.y * edge2;
    Interaction surface;
    surface.position = triangle.v0 + (along1 + along2);
    surface.ng = triangleNormal(edge1, edge2);
    surface.error = triangleError(surface.position, along1, along2, surface.ng);
    surface.ns = surface.ng;
    if (hasSmoothNormals) {
        TriangleNormals normals = loadTriangleNormals(index);
        vec3 n = (1.0 - b.x - b.y) * normals.n0 + b.x * normals.n1 + b.y * normals.n2;
        float nn = dot(n, n);
        n = nn > 0.0 ? n * inversesqrt(nn) : surface.ng;
        surface.ns = dot(n, surface.ng) < 0.0 ? -n : n;
    }
    surface.material = triangle.material;
    surface.light = triangle.light;
    surface.id = triangle.id;
    return surface;
}

Interaction quadricInteraction(uint index, Ray ray, float t) {
    Quadric quadric = loadQuadric(index);
    vec3 local = (ray.origin - quadric.center + t * ray.direction) * worldFromQuadric(quadric);
    QuadricPoint point = quadricPoint(quadric, local);
    return Interaction(point.position, point.error, point.normal, point.normal, quadric.material,
                       quadric.light, quadric.id);
}

Interaction interactionAt(Hit hit, Ray ray) {
    if (hasQuadrics && (!hasTriangles || (hit.primitive & kQuadricBit) != 0u))
        return quadricInteraction(hit.primitive & ~kQuadricBit, ray, hit.t);
    return triangleInteraction(hit.primitive, ray);
}

#endif
