// Sphere |p| = radius (report eq. 1.1 to 1.4), as the quadratic
//     f(t) = |o + t d|^2 - r^2,  a = d.d,  b = o.d,  c = o.o - r^2,  D = r^2 d.d - |o x d|^2.
// Valid for any origin, radius and length of d whose squares neither overflow nor underflow.
// The hit is then projected onto the surface, so its error does not grow with the distance.
#ifndef CALOTYPE_SHAPES_SPHERE_GLSL
#define CALOTYPE_SHAPES_SPHERE_GLSL

#include "shapes/local_ray.glsl"
#include "shapes/quadratic.glsl"
#include "shapes/slab.glsl"

/// Parameter of the first crossing, or kFar.
float intersectSphere(LocalRay ray, float radius) {
    vec3 o = ray.origin;
    vec3 d = ray.direction;
    vec3 moment = cross(o, d);
    float a = dot(d, d);
    float oo = dot(o, o);
    float rr = radius * radius;
    float cError = GAMMA(6.0) * (oo + rr) + 2.0 * dot(abs(o), ray.error);
    float near, far;
    bool hit =
        quadraticRoots(a, dot(o, d), oo - rr, cError, rr * a - dot(moment, moment), near, far);
    vec2 interval = vec2(min(near, far), max(near, far));
    return hit ? firstCrossing(interval) : kFar;
}

/// The point of the sphere nearest to p.
vec3 projectOntoSphere(vec3 p, float radius) { return p * (radius * inversesqrt(dot(p, p))); }

/// Outward unit normal at a point of the sphere.
vec3 sphereNormal(vec3 p) { return p * inversesqrt(dot(p, p)); }

#endif
