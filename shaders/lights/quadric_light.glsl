// What lights that are quadrics have in common. All but the sphere are sampled by uniform points on
// their area (docs/models.md, "Quadric lights"). From outside, only the parts of a closed convex
// surface that face the point are visible; from inside, all of it is.
#ifndef CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL
#define CALOTYPE_LIGHTS_QUADRIC_LIGHT_GLSL

#include "buffers/packed_scene.glsl"
#include "lights/area_light.glsl"
#include "shapes/quadric.glsl"
#include "shapes/surface_coordinates.glsl"

/// `kind` is that of the quadric. As the light's kind says it, code for other kinds is left out.
Quadric quadricOf(Light light, uint kind) {
    Quadric quadric = loadQuadric(light.primitive & ~kQuadricBit);
    quadric.kind = kind;
    return quadric;
}

/// True if p, in the quadric's frame, is inside a sphere, cylinder or cone.
bool isInsideQuadric(Quadric quadric, vec3 p) {
    if (quadric.kind == kSphere)
        return dot(p, p) < quadric.radius * quadric.radius;
    float y = quadric.kind == kCylinder ? abs(p.y) : p.y * sign(quadric.extent);
    float yMax = quadric.kind == kCylinder ? 0.5 * quadric.extent : abs(quadric.extent);
    float radius = quadric.kind == kCylinder ? quadric.radius : quadric.slope * y;
    return y <= yMax && y >= 0.0 && dot(p.xz, p.xz) < radius * radius;
}

/// True if the near side of a closed quadric hides this point of it from `shadingPoint`.
bool isOnFarSide(Quadric quadric, vec3 shadingPoint, vec3 position, vec3 normal) {
    bool facesAway = dot(shadingPoint - position, normal) < 0.0;
    return facesAway &&
           !isInsideQuadric(quadric, (shadingPoint - quadric.center) * worldFromQuadric(quadric));
}

/// True if a ray found the point on the far side, through a transparent point of the near side.
bool isMetOnFarSide(Light light, uint kind, vec3 shadingPoint, LightPoint point) {
    return hasAlpha &&
           isOnFarSide(quadricOf(light, kind), shadingPoint, point.position, point.normal);
}

/// A point of a quadric, given in the quadric's frame.
LightPoint quadricLightPoint(Quadric quadric, vec3 local, vec3 shadingPoint) {
    QuadricPoint surface = quadricPoint(quadric, local);
    vec2 uv = hasAlpha ? quadricCoordinates(quadric, local).uv : vec2(0.0);
    vec3 wi = normalize(surface.position - shadingPoint);
    return LightPoint(wi, surface.position, surface.error, surface.normal, uv);
}

/// A uniform point of a closed quadric.
LightSample closedQuadricSample(Light light, Quadric quadric, vec3 local, vec3 shadingPoint) {
    LightPoint point = quadricLightPoint(quadric, local, shadingPoint);
    bool isHidden = isOnFarSide(quadric, shadingPoint, point.position, point.normal);
    return LightSample(point, isHidden ? 0.0 : uniformPointPdf(light, shadingPoint, point));
}

float closedQuadricPdf(Light light, uint kind, vec3 shadingPoint, LightPoint point) {
    return isMetOnFarSide(light, kind, shadingPoint, point)
               ? 0.0
               : uniformPointPdf(light, shadingPoint, point);
}

#endif
