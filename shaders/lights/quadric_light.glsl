// Disks, cylinders and cones are sampled by uniform points on their area (docs/models.md, "Quadric
// lights"). From outside, only the parts of a closed convex surface that face the point are
// visible; from inside, all of it is.
#ifndef CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL
#define CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL

#include "lights/area_light.glsl"
#include "lights/cone_light.glsl"
#include "lights/cylinder_light.glsl"
#include "lights/disk_light.glsl"
#include "shapes/quadric.glsl"
#include "shapes/surface_coordinates.glsl"

/// True if p, in the quadric's frame, is inside a sphere, cylinder or cone.
bool isInsideQuadric(Quadric quadric, vec3 p) {
    if (quadric.kind == kSphere)
        return dot(p, p) < quadric.radius * quadric.radius;
    float y = quadric.kind == kCylinder ? abs(p.y) : p.y * sign(quadric.extent);
    float yMax = quadric.kind == kCylinder ? 0.5 * quadric.extent : abs(quadric.extent);
    float radius = quadric.kind == kCylinder ? quadric.radius : quadric.slope * y;
    return y <= yMax && y >= 0.0 && dot(p.xz, p.xz) < radius * radius;
}

/// True if the near side of a closed quadric hides this point of it from `reference`.
bool isOnFarSide(Quadric quadric, vec3 reference, vec3 position, vec3 normal) {
    bool facesAway = dot(reference - position, normal) < 0.0;
    return quadric.kind != kDisk && facesAway &&
           !isInsideQuadric(quadric, (reference - quadric.center) * worldFromQuadric(quadric));
}

/// `kind` is Light.kind: a cylinder, a cone or a disk.
LightSample sampleQuadricLight(uint kind, Quadric quadric, float area, vec3 reference, vec2 u) {
    vec3 local;
    if (hasCylinderLights && kind == kLightCylinder)
        local = sampleCylinder(quadric.radius, quadric.extent, u);
    else if (hasConeLights && kind == kLightCone)
        local = sampleCone(quadric.radius, quadric.extent, u);
    else
        local = sampleDisk(quadric.radius, u);
    QuadricPoint surface = quadricPoint(quadric, local);
    vec2 uv = hasAlpha ? quadricCoordinates(quadric, local).uv : vec2(0.0);
    vec3 wi = normalize(surface.position - reference);
    bool isHidden = isOnFarSide(quadric, reference, surface.position, surface.normal);
    float pdf = isHidden ? 0.0 : solidAnglePdf(area, reference, surface.position, surface.normal);
    return LightSample(LightPoint(wi, surface.position, surface.error, surface.normal, uv), pdf);
}

#endif
