// Closed cylinder x^2 + z^2 <= r^2, |y| <= h / 2 (docs/models.md, "Cylinder"): the line is inside
// if it is inside both the infinite cylinder and the slab between the caps. The two intervals are
// intersected, because testing each candidate against the limits of the other surface leaves gaps
// along the rims.
//     f(t) in x and z alone: a = dx^2 + dz^2,  b = ox dx + oz dz,  c = ox^2 + oz^2 - r^2,
//     D = r^2 a - (oz dx - ox dz)^2.
// A ray along the axis has a = 0: then c decides whether it is inside everywhere or nowhere.
#ifndef CALOTYPE_SHAPES_CYLINDER_GLSL
#define CALOTYPE_SHAPES_CYLINDER_GLSL

#include "shapes/local_ray.glsl"
#include "shapes/quadratic.glsl"
#include "shapes/slab.glsl"

/// Parameter of the first crossing of side or caps, or kFar.
float intersectCylinder(LocalRay ray, float radius, float height) {
    vec2 o = ray.origin.xz;
    vec2 d = ray.direction.xz;
    float moment = o.y * d.x - o.x * d.y;
    float a = dot(d, d);
    float oo = dot(o, o);
    float rr = radius * radius;
    float cError = GAMMA(5.0) * (oo + rr) + 2.0 * dot(abs(o), ray.error.xz);
    float near, far;
    bool hit = quadraticRoots(a, dot(o, d), oo - rr, cError, rr * a - moment * moment, near, far);
    bool parallel = a == 0.0;
    hit = parallel ? oo < rr : hit;
    vec2 side = parallel ? vec2(-kFar, kFar) : vec2(min(near, far), max(near, far));
    float yError = ray.error.y + GAMMA(2.0) * abs(ray.origin.y);
    vec2 caps = slabInterval(ray.origin.y, ray.direction.y, -0.5 * height, 0.5 * height, yError);
    return hit ? firstCrossing(vec2(max(side.x, caps.x), min(side.y, caps.y))) : kFar;
}

/// True if p is nearer to a cap than to the side.
bool isOnCylinderCap(vec3 p, float radius, float height) {
    return abs(abs(p.y) - 0.5 * height) < abs(length(p.xz) - radius);
}

/// The nearest point on the surface, at least `margin` away from a rim; that in direction x for a
/// point on the axis.
vec3 projectOntoCylinder(vec3 p, float radius, float height, float margin) {
    float distance = length(p.xz);
    if (isOnCylinderCap(p, radius, height)) {
        float farthest = max(radius - margin, 0.0);
        vec2 xz = p.xz * (distance > farthest ? farthest / distance : 1.0);
        return vec3(xz.x, p.y < 0.0 ? -0.5 * height : 0.5 * height, xz.y);
    }
    float highest = max(0.5 * height - margin, 0.0);
    vec2 xz = distance > 0.0 ? p.xz * (radius / distance) : vec2(radius, 0.0);
    return vec3(xz.x, clamp(p.y, -highest, highest), xz.y);
}

/// Outward unit normal at a point near the surface; a point on the rim belongs to the side. On
/// the axis it is the direction x.
vec3 cylinderNormal(vec3 p, float radius, float height) {
    if (isOnCylinderCap(p, radius, height))
        return vec3(0.0, p.y < 0.0 ? -1.0 : 1.0, 0.0);
    float square = dot(p.xz, p.xz);
    vec2 outward = square > 0.0 ? p.xz * inversesqrt(square) : vec2(1.0, 0.0);
    return vec3(outward.x, 0.0, outward.y);
}

#endif
