// Uniform points on disks and on the closed surfaces of cylinders and cones. A closed convex
// surface shows a point outside only what faces it, and a point inside everything.
#ifndef CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL
#define CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL

#include "core/warp.glsl"
#include "lights/surface_sample.glsl"
#include "shapes/quadric.glsl"
#include "shapes/surface_coordinates.glsl"

/// Uniform on the side and both caps, each chosen by its area.
vec3 sampleCylinder(float radius, float height, vec2 u) {
    float capShare = 0.5 * radius / (height + radius);
    bool lower = u.x < capShare;
    if (lower || u.x >= 1.0 - capShare) {
        float rest = (lower ? u.x : 1.0 - u.x) / capShare;
        vec2 p = radius * warpToDisk(vec2(min(rest, 1.0), u.y));
        return vec3(p.x, lower ? -0.5 * height : 0.5 * height, p.y);
    }
    float rest = (u.x - capShare) / (1.0 - 2.0 * capShare);
    vec2 sinCos = sinCosTwoPi(u.y);
    return vec3(radius * sinCos.y, (rest - 0.5) * height, radius * sinCos.x);
}

/// Uniform on the side and the base, each chosen by its area; on the side the distance from the
/// apex goes as the square root, since circumference grows with it.
vec3 sampleCone(float radius, float height, vec2 u) {
    float slant = sqrt(radius * radius + height * height);
    float baseShare = radius / (radius + slant);
    if (u.x < baseShare) {
        vec2 p = radius * warpToDisk(vec2(u.x / baseShare, u.y));
        return vec3(p.x, height, p.y);
    }
    float fromApex = sqrt((u.x - baseShare) / (1.0 - baseShare));
    vec2 sinCos = sinCosTwoPi(u.y);
    return fromApex * vec3(radius * sinCos.y, height, radius * sinCos.x);
}

/// True where p, in the quadric's frame, lies inside a sphere, cylinder or cone.
bool isInsideQuadric(Quadric quadric, vec3 p) {
    if (quadric.kind == kSphere)
        return dot(p, p) < quadric.radius * quadric.radius;
    float y = quadric.kind == kCylinder ? abs(p.y) : p.y * sign(quadric.extent);
    float yMax = quadric.kind == kCylinder ? 0.5 * quadric.extent : abs(quadric.extent);
    float radius = quadric.kind == kCylinder ? quadric.radius : quadric.slope * y;
    return y <= yMax && y >= 0.0 && dot(p.xz, p.xz) < radius * radius;
}

/// True for a point of a closed quadric that its own near side hides from `reference`.
bool isOnFarSide(Quadric quadric, vec3 reference, vec3 position, vec3 normal) {
    bool facesAway = dot(reference - position, normal) < 0.0;
    return quadric.kind != kDisk && facesAway &&
           !isInsideQuadric(quadric, (reference - quadric.center) * worldFromQuadric(quadric));
}

SurfaceSample sampleQuadricLight(Quadric quadric, float area, vec3 reference, vec2 u) {
    vec3 local = vec3(0.0);
    if (hasCylinderLights && quadric.kind == kCylinder) {
        local = sampleCylinder(quadric.radius, quadric.extent, u);
    } else if (hasConeLights && quadric.kind == kCone) {
        local = sampleCone(quadric.radius, quadric.extent, u);
    } else {
        local.xz = quadric.radius * warpToDisk(u);
    }
    QuadricPoint point = quadricPoint(quadric, local);
    bool hidden = isOnFarSide(quadric, reference, point.position, point.normal);
    float pdf = hidden ? 0.0 : solidAnglePdf(area, reference, point.position, point.normal);
    vec2 uv = hasAlpha ? quadricCoordinates(quadric, local).uv : vec2(0.0);
    vec3 wi = normalize(point.position - reference);
    return SurfaceSample(point.position, point.error, point.normal, wi, pdf, uv);
}

#endif
