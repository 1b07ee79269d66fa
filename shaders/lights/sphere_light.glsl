// From outside, samples uniform directions in the cone that the sphere subtends; from inside,
// uniform points on the whole surface (docs/models.md, "Sphere light").
#ifndef CALOTYPE_LIGHTS_SPHERE_LIGHT_GLSL
#define CALOTYPE_LIGHTS_SPHERE_LIGHT_GLSL

#include "core/frame.glsl"
#include "core/trigonometry.glsl"
#include "lights/quadric_light.glsl"

/// With a constant kind, so that code for other quadrics is left out.
Quadric sphereOf(Light light) {
    Quadric sphere = quadricOf(light);
    sphere.kind = kSphere;
    return sphere;
}

/// 1 - cos of the half angle that a sphere subtends, from sin^2; without cancellation.
float oneMinusConeCosine(float sin2ThetaMax) {
    return sin2ThetaMax / (1.0 + sqrt(max(1.0 - sin2ThetaMax, 0.0)));
}

/// (r / distance)^2 seen from `shadingPoint`: at least 1 from inside.
float sphereSin2(Quadric sphere, vec3 shadingPoint) {
    vec3 toShadingPoint = shadingPoint - sphere.center;
    return sphere.radius * sphere.radius / dot(toShadingPoint, toShadingPoint);
}

/// The density of a point on the near side.
float spherePdf(Light light, Quadric sphere, vec3 shadingPoint, LightPoint point) {
    float sin2ThetaMax = sphereSin2(sphere, shadingPoint);
    return sin2ThetaMax < 1.0 ? 1.0 / (kTwoPi * oneMinusConeCosine(sin2ThetaMax))
                              : uniformPointPdf(light, shadingPoint, point);
}

/// Let theta be the angle of the sampled direction to the axis, from the shading point to the
/// centre. At the centre, the point is at the angle beta - theta to the axis, where sin beta = sin
/// theta / sin thetaMax (law of sines). wi is the sampled direction, not a difference of positions.
/// So a shading point on the sphere itself gets no light, because the whole cone is below its
/// surface.
LightSample sampleSphereLight(Light light, vec3 shadingPoint, vec2 u) {
    Quadric sphere = sphereOf(light);
    vec3 toShadingPoint = shadingPoint - sphere.center;
    float sin2ThetaMax = sphereSin2(sphere, shadingPoint);
    bool outside = sin2ThetaMax < 1.0;
    // theta: the angle in the cone, off its axis, from 1 - cos theta.
    vec2 phi = sinCosTwoPi(u.y);
    float oneMinusCos = outside ? u.x * oneMinusConeCosine(sin2ThetaMax) : 0.0;
    float sin2Theta = oneMinusCos * (2.0 - oneMinusCos);
    float sinTheta = sqrt(sin2Theta);
    // alpha: the angle at the centre, beta - theta; inside, that of a uniform point.
    float sinAlpha, cosAlpha;
    if (outside) {
        float sin2Beta = min(sin2Theta / sin2ThetaMax, 1.0);
        float sinBeta = sqrt(sin2Beta);
        float cosBeta = sqrt(1.0 - sin2Beta);
        sinAlpha = sinBeta * (1.0 - oneMinusCos) - cosBeta * sinTheta;
        cosAlpha = cosBeta * (1.0 - oneMinusCos) + sinBeta * sinTheta;
    } else {
        cosAlpha = 1.0 - 2.0 * u.x;
        sinAlpha = 2.0 * sqrt(u.x * (1.0 - u.x));
    }
    // The point on the sphere, about the axis from the centre to the shading point.
    float distance2 = dot(toShadingPoint, toShadingPoint);
    vec3 axis = distance2 > 0.0 ? toShadingPoint * inversesqrt(distance2) : vec3(0.0, 1.0, 0.0);
    mat3 worldFromCone = worldFromLocal(axis);
    vec3 direction = worldFromCone * vec3(sinAlpha * phi.y, sinAlpha * phi.x, cosAlpha);
    vec3 local = direction * worldFromQuadric(sphere);
    QuadricPoint surface = quadricPoint(sphere, local);
    // The direction to it: outside the cone's own, inside the difference of the points.
    vec3 alongCone = worldFromCone * vec3(sinTheta * phi.y, sinTheta * phi.x, oneMinusCos - 1.0);
    vec3 wi = outside ? alongCone : normalize(surface.position - shadingPoint);
    vec2 uv = hasAlpha ? sphereCoordinates(local).uv : vec2(0.0);
    LightPoint point = LightPoint(wi, surface.position, surface.error, surface.normal, uv);
    return LightSample(point, spherePdf(light, sphere, shadingPoint, point));
}

float pdfOfSphereLight(Light light, vec3 shadingPoint, LightPoint point) {
    Quadric sphere = sphereOf(light);
    return isMetOnFarSide(sphere, shadingPoint, point)
               ? 0.0
               : spherePdf(light, sphere, shadingPoint, point);
}

vec3 radianceOfSphereLight(Light light, LightPoint point) {
    return areaLightRadiance(light, point);
}

#endif
