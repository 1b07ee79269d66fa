// Texture coordinates, and their tangents dp/du and dp/dv.
#ifndef CALOTYPE_SHAPES_SURFACE_COORDINATES_GLSL
#define CALOTYPE_SHAPES_SURFACE_COORDINATES_GLSL

#include "config/features.glsl"
#include "core/trigonometry.glsl"
#include "shapes/cone.glsl"
#include "shapes/cylinder.glsl"
#include "shared/scene_structs.h"

struct SurfaceCoordinates {
    vec2 uv;
    vec3 dpdu; ///< in the direction of growing u, of any length; zero if u has no direction
    vec3 dpdv; ///< likewise for v
};

/// u goes around the y axis, from x towards z; the caller gives v.
SurfaceCoordinates aroundAxis(vec3 p, float v, vec3 dpdv) {
    return SurfaceCoordinates(vec2(angleInTurns(p.x, p.z), v), vec3(-p.z, 0.0, p.x), dpdv);
}

/// On caps, bases and disks: the square around the circle.
SurfaceCoordinates acrossDisk(vec3 p, float radius) {
    return SurfaceCoordinates(0.5 + 0.5 * p.xz / radius, vec3(1.0, 0.0, 0.0), vec3(0.0, 0.0, 1.0));
}

/// v is the angle from -y over pi.
SurfaceCoordinates sphereCoordinates(vec3 p) {
    float xz2 = dot(p.xz, p.xz);
    return aroundAxis(p, 2.0 * angleInTurns(-p.y, sqrt(xz2)), vec3(-p.x * p.y, xz2, -p.z * p.y));
}

SurfaceCoordinates cylinderCoordinates(vec3 p, float radius, float height) {
    if (isOnCylinderCap(p, radius, height))
        return acrossDisk(p, radius);
    return aroundAxis(p, p.y / height + 0.5, vec3(0.0, 1.0, 0.0));
}

/// On the side v is 0 at the lower end, which is the apex or the base.
SurfaceCoordinates coneCoordinates(vec3 p, float radius, float height, float slope) {
    if (isOnConeBase(p, height, slope))
        return acrossDisk(p, radius);
    float fromApex = p.y / height;
    return height < 0.0 ? aroundAxis(p, 1.0 - fromApex, -p) : aroundAxis(p, fromApex, p);
}

/// For a point in the quadric's frame; the tangents are in that frame too.
SurfaceCoordinates quadricCoordinates(Quadric quadric, vec3 p) {
    if (hasSpheres && quadric.kind == kSphere)
        return sphereCoordinates(p);
    if (hasCylinders && quadric.kind == kCylinder)
        return cylinderCoordinates(p, quadric.radius, quadric.extent);
    if (hasCones && quadric.kind == kCone)
        return coneCoordinates(p, quadric.radius, quadric.extent, quadric.slope);
    return acrossDisk(p, quadric.radius);
}

vec2 triangleUv(TriangleUvs uvs, vec2 barycentrics) {
    return (1.0 - barycentrics.x - barycentrics.y) * uvs.uv0 + barycentrics.x * uvs.uv1 +
           barycentrics.y * uvs.uv2;
}

/// The tangents of docs/models.md, "Tangents", except for their lengths: only the sign of the
/// determinant is used, so there is no division. Differences of uvs below 1e-19 count as zero.
SurfaceCoordinates triangleCoordinates(TriangleUvs uvs, vec2 barycentrics, vec3 edge1, vec3 edge2) {
    vec2 uv1 = uvs.uv1 - uvs.uv0;
    vec2 uv2 = uvs.uv2 - uvs.uv0;
    float orientation = sign(uv1.x * uv2.y - uv2.x * uv1.y);
    return SurfaceCoordinates(triangleUv(uvs, barycentrics),
                              orientation * (uv2.y * edge1 - uv1.y * edge2),
                              orientation * (uv1.x * edge2 - uv2.x * edge1));
}

#endif
