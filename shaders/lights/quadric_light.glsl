// What lights that are quadrics have in common (docs/models.md, "Quadric lights"). From outside,
// only the parts of a closed convex surface that face the point are visible; from inside, all of it
// is.
#ifndef CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL
#define CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "lights/area_light.glsl"
#include "shapes/quadric.glsl"
#include "shapes/surface_coordinates.glsl"

Quadric quadricOf(Light light) { return loadQuadric(light.primitive & ~kQuadricBit); }

/// True if p, in the quadric's frame, is inside a sphere, cylinder or cone.
bool isInsideQuadric(Quadric quadric, vec3 p) {
    if (quadric.kind == kSphere)
        return dot(p, p) < quadric.radius * quadric.radius;
    float y = quadric.kind == kCylinder ? abs(p.y) : p.y * sign(quadric.extent);
    float yMax = quadric.kind == kCylinder ? 0.5 * quadric.extent : abs(quadric.extent);
    float radius = quadric.kind == kCylinder ? quadric.radius : quadric.slope * y;
    return y <= yMax && y >= 0.0 && dot(p.xz, p.xz) < radius * radius;
}

/// True if the near side of a closed quadric hides this point of it from `shadingPoint`. A disk has
/// no far side.
bool isOnFarSide(Quadric quadric, vec3 shadingPoint, vec3 position, vec3 normal) {
    bool facesAway = quadric.kind != kDisk && dot(shadingPoint - position, normal) < 0.0;
    return facesAway &&
           !isInsideQuadric(quadric, (shadingPoint - quadric.center) * worldFromQuadric(quadric));
}

/// True if a ray found the point on the far side, through a transparent point of the near side.
bool isMetOnFarSide(Quadric quadric, vec3 shadingPoint, LightPoint point) {
    return hasAlpha && isOnFarSide(quadric, shadingPoint, point.position, point.normal);
}

/// A point of a quadric, given in the quadric's frame.
LightPoint quadricLightPoint(Quadric quadric, vec3 local, vec3 shadingPoint) {
    QuadricPoint surface = quadricPoint(quadric, local);
    vec2 uv = hasAlpha ? quadricCoordinates(quadric, local).uv : vec2(0.0);
    vec3 wi = normalize(surface.position - shadingPoint);
    return LightPoint(wi, surface.position, surface.error, surface.normal, uv);
}

#endif
