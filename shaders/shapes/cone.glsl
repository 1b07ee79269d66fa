// Closed cone with its apex at the origin: x^2 + z^2 <= k^2 y^2 for y between 0 and the signed
// height h (docs/models.md, "Cone"). The solid is convex, so a line is inside it on one interval.
//     f(t) = x^2 + z^2 - k^2 y^2:  a = dx^2 + dz^2 - k^2 dy^2,  b = ox dx + oz dz - k^2 oy dy,
//     D = k^2 (mx^2 + mz^2) - my^2  with the moment m = o x d.
// Three cases of the leading coefficient:
//   a > 0  the line is flatter than the surface: inside between the roots, all in one nappe;
//   a < 0  steeper: outside between the roots, and inside our nappe beyond the root that lies in
//          the direction in which the line climbs towards the base;
//   a = 0  parallel to a line of the surface: the case a < 0 with one root at infinity.
// All three coefficients cancel for far origins: beyond twice the cone's size, the quadratic is set
// up at the line's point nearest to the apex, where no ray starts. The mirror nappe never counts:
// the slab 0 <= y / h <= 1 rejects it in the first case, and the chosen half line excludes it in
// the second. Slab and surface are intersected as intervals: no ray passes between them at the rim.
#ifndef CALOTYPE_SHAPES_CONE_GLSL
#define CALOTYPE_SHAPES_CONE_GLSL

#include "shapes/local_ray.glsl"
#include "shapes/quadratic.glsl"
#include "shapes/slab.glsl"

/// Parameter of the first crossing of side or base, or kFar if there is none.
float intersectCone(LocalRay ray, float height, float slope) {
    // Mirrored so that the base is above the apex.
    float towardBase = height < 0.0 ? -1.0 : 1.0;
    vec3 o = vec3(ray.origin.x, ray.origin.y * towardBase, ray.origin.z);
    vec3 d = vec3(ray.direction.x, ray.direction.y * towardBase, ray.direction.z);
    // From afar, start at the point nearest to the apex.
    float kk = slope * slope;
    bool fromAfar = dot(o, o) > 4.0 * height * height * (1.0 + kk);
    float shift = fromAfar ? -dot(o, d) / dot(d, d) : 0.0;
    o += shift * d;
    // The coefficients, and a bound on the error of c = oo - kyy.
    vec3 moment = cross(o, d);
    float a = dot(d.xz, d.xz) - kk * d.y * d.y;
    float b = dot(o.xz, d.xz) - kk * o.y * d.y;
    float oo = dot(o.xz, o.xz);
    float kyy = kk * o.y * o.y;
    float cError = GAMMA(6.0) * (oo + kyy) +
                   2.0 * (dot(abs(o.xz), ray.error.xz) + kk * abs(o.y) * ray.error.y);
    cError = fromAfar ? 0.0 : cError;
    float discriminant = kk * dot(moment.xz, moment.xz) - moment.y * moment.y;
    // The interval inside the side, by the three cases above.
    a = a == 0.0 ? -1e-30 : a;
    float near, far;
    bool hit = quadraticRoots(a, b, oo - kyy, cError, discriminant, near, far);
    float first = min(near, far);
    float second = max(near, far);
    vec2 side = a > 0.0 ? vec2(first, second) : d.y > 0.0 ? vec2(second, kFar) : vec2(-kFar, first);
    // The interval between apex and base, and what is in both.
    float yError = ray.error.y + GAMMA(2.0) * abs(o.y);
    vec2 base = slabInterval(o.y, d.y, 0.0, abs(height), yError);
    vec2 interval = vec2(max(side.x, base.x), min(side.y, base.y)) + shift;
    return hit ? firstCrossing(interval) : kFar;
}

/// True if p is nearer to the base than to the side.
bool isOnConeBase(vec3 p, float height, float slope) {
    float toSide = abs(length(p.xz) - slope * abs(p.y)) * inversesqrt(1.0 + slope * slope);
    return abs(p.y - height) < toSide;
}

/// The nearest point on the surface, at least `margin` away from the rim.
vec3 projectOntoCone(vec3 p, float height, float slope, float margin) {
    float radius = length(p.xz);
    if (isOnConeBase(p, height, slope)) {
        float farthest = max(slope * abs(height) - margin, 0.0);
        vec2 xz = p.xz * (radius > farthest ? farthest / radius : 1.0);
        return vec3(xz.x, height, xz.y);
    }
    // In (radius, |y|), onto the line radius = slope |y|; a point on the axis goes to the apex.
    float y = (abs(p.y) + slope * radius) / (1.0 + slope * slope);
    y = min(y, max(abs(height) - margin * inversesqrt(1.0 + slope * slope), 0.0));
    vec2 side = radius > 0.0 ? p.xz * (slope * y / radius) : vec2(0.0);
    y = radius > 0.0 ? y : 0.0;
    return vec3(side.x, height < 0.0 ? -y : y, side.y);
}

/// Outward unit normal at a point near the surface. At the apex it is the axis, away from the base.
vec3 coneNormal(vec3 p, float height, float slope) {
    float towardBase = height < 0.0 ? -1.0 : 1.0;
    if (isOnConeBase(p, height, slope))
        return vec3(0.0, towardBase, 0.0);
    float radius = length(p.xz);
    if (radius == 0.0)
        return vec3(0.0, -towardBase, 0.0);
    // On the side: across the line from the apex.
    float scale = inversesqrt(1.0 + slope * slope);
    return vec3(p.x / radius * scale, -towardBase * slope * scale, p.z / radius * scale);
}

#endif
