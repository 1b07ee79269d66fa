// From a hit to the surface data that shading needs.
#ifndef CALOTYPE_SCENE_INTERACTION_GLSL
#define CALOTYPE_SCENE_INTERACTION_GLSL

#include "accel/traversal.glsl"
#include "shapes/surface_coordinates.glsl"
#include "shapes/terminator.glsl"
#include "shapes/triangle_barycentrics.glsl"
#include "shapes/triangle_point.glsl"

struct Interaction {
    vec3 position;
    float error;   ///< bound on the distance along ng between `position` and the true surface
    vec3 ng;       ///< unit geometric normal, outward
    vec3 ns;       ///< unit shading normal, on the side of ng
    vec3 horizon;  ///< unit normal below which the surface cannot be lit: ng, or ns where smooth
    vec3 toSmooth; ///< from `position` to the origin of rays on the ray's side
    SurfaceCoordinates coordinates;
    uint material; ///< index, with kTransparentBit
    uint light;    ///< or kNone
    uint id;       ///< the primitive's number in the scene file
};

/// Sets the interpolated normal, and the offset of the smooth surface from the triangle.
void smoothen(inout Interaction surface, Triangle triangle, TriangleNormals normals,
              vec2 barycentrics, vec3 direction) {
    vec3 n = (1.0 - barycentrics.x - barycentrics.y) * normals.n0 + barycentrics.x * normals.n1 +
             barycentrics.y * normals.n2;
    float nn = dot(n, n);
    n = nn > 0.0 ? n * inversesqrt(nn) : surface.ng;
    float outward = dot(n, surface.ng) < 0.0 ? -1.0 : 1.0;
    float side = dot(direction, surface.ng) > 0.0 ? -1.0 : 1.0;
    surface.ns = outward * n;
    vec3 offset =
        terminatorOffset(triangle, normals, surface.position, barycentrics, outward * side);
    bool isConvex = side * dot(offset, surface.ng) > 0.0;
    surface.toSmooth = isConvex ? offset : vec3(0.0);
    surface.horizon = isConvex ? surface.ns : surface.ng;
}

/// The point comes from the barycentrics, and the base corner is added last: its error is relative
/// to the triangle, not to the length of the ray (Pharr, Jakob and Humphreys, PBR 3.9 and 6.8).
Interaction triangleInteraction(uint index, Ray ray) {
    Triangle triangle = loadTriangle(index);
    vec3 edge1 = triangle.v1 - triangle.v0;
    vec3 edge2 = triangle.v2 - triangle.v0;
    vec2 b = triangleBarycentrics(shearedRay(ray.origin, ray.direction), triangle);
    vec3 along1 = b.x * edge1;
    vec3 along2 = b.y * edge2;
    Interaction surface;
    surface.position = triangle.v0 + (along1 + along2);
    surface.ng = normalOf(triangle);
    surface.error = triangleError(surface.position, along1, along2, surface.ng);
    surface.ns = surface.ng;
    surface.horizon = surface.ng;
    surface.toSmooth = vec3(0.0);
    if (hasSmoothNormals)
        smoothen(surface, triangle, loadTriangleNormals(index), b, ray.direction);
    if (hasTextures)
        surface.coordinates = triangleCoordinates(loadTriangleUvs(index), b, edge1, edge2);
    surface.material = triangle.material;
    surface.light = triangle.light;
    surface.id = triangle.id;
    return surface;
}

Interaction quadricInteraction(uint index, Ray ray, float t) {
    Quadric quadric = loadQuadric(index);
    mat3 frame = worldFromQuadric(quadric);
    vec3 local = (ray.origin - quadric.center + t * ray.direction) * frame;
    bool isSphere = hasSpheres && quadric.kind == kSphere;
    QuadricPoint point = isSphere ? spherePoint(quadric, ray.origin + t * ray.direction)
                                  : quadricPoint(quadric, local);
    Interaction surface;
    surface.position = point.position;
    surface.error = point.error;
    surface.ng = point.normal;
    surface.ns = point.normal;
    surface.horizon = point.normal;
    surface.toSmooth = vec3(0.0);
    if (hasTextures) {
        surface.coordinates = quadricCoordinates(quadric, local);
        surface.coordinates.dpdu = frame * surface.coordinates.dpdu;
        surface.coordinates.dpdv = frame * surface.coordinates.dpdv;
    }
    surface.material = quadric.material;
    surface.light = quadric.light;
    surface.id = quadric.id;
    return surface;
}

Interaction interactionAt(Hit hit, Ray ray) {
    if (hasQuadrics && (!hasTriangles || (hit.primitive & kQuadricBit) != 0u))
        return quadricInteraction(hit.primitive & ~kQuadricBit, ray, hit.t);
    return triangleInteraction(hit.primitive, ray);
}

#endif
