// A point chosen on an emitter.
#ifndef CALOTYPE_LIGHTS_SURFACE_SAMPLE_GLSL
#define CALOTYPE_LIGHTS_SURFACE_SAMPLE_GLSL

struct SurfaceSample {
    vec3 position;
    float error; ///< bound on the distance along `normal` between `position` and the true surface
    vec3 normal; ///< of the front
    vec3 wi;     ///< unit direction from the reference point
    float pdf; ///< per solid angle at the reference point; 0 where the point cannot be seen from it
    vec2 coordinates; ///< barycentrics on a triangle, texture coordinates on a quadric
};

/// The density 1 / area as one per solid angle (docs/models.md, "Direct light"):
/// distance^2 / (cos theta area). Zero edge on.
float solidAnglePdf(float area, vec3 reference, vec3 position, vec3 normal) {
    vec3 d = position - reference;
    float distance2 = dot(d, d);
    float cosTheta = abs(dot(d * inversesqrt(distance2), normal));
    return cosTheta > 0.0 ? distance2 / (cosTheta * area) : 0.0;
}

#endif
