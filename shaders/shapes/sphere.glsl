// Sphere |p| = radius (docs/models.md, "Sphere"), as the quadratic
//     f(t) = |o + t d|^2 - r^2,  a = d.d,  b = o.d,  c = o.o - r^2.
// Near the surface c cancels: for a sphere of a thousand kilometres, a float c would give the
// height of a point only to decimetres. So the centre has a second float for each coordinate, and c
// is the sum with the errors of its sums and products, accurate to 2^-44 of o.o + r^2: for that
// sphere, a ten thousandth of a millimetre. Near the surface, D is b^2 - a c, with a rounding
// relative to b^2, which is small towards the horizon; from far away it is D = r^2 d.d - |o x d|^2.
// Valid for any origin, radius and length of d whose squares do not overflow or underflow. The hit
// is then moved onto the surface with the same c, so its error grows neither with the distance nor
// with the radius.
#ifndef CALOTYPE_SHAPES_SPHERE_GLSL
#define CALOTYPE_SHAPES_SPHERE_GLSL

#include "core/error_free.glsl"
#include "core/rounding.glsl"
#include "shapes/quadratic.glsl"
#include "shapes/slab.glsl"

/// A point relative to a sphere.
struct SpherePosition {
    vec3 fromCenter;
    float power;      ///< |p - center|^2 - radius^2: above 0 outside
    float powerError; ///< bound on the error of `power`
};

/// `centerRest` is the rounding error of `center`. The bound: the sums and products of the errors
/// have about eight roundings, relative to terms that are themselves roundings.
SpherePosition spherePosition(vec3 p, vec3 center, vec3 centerRest, float radius) {
    // v + rest is p - center, but for the rounding of `rest`.
    precise vec3 v = p - center;
    precise vec3 rest = vec3(sumError(p.x, -center.x, v.x), sumError(p.y, -center.y, v.y),
                             sumError(p.z, -center.z, v.z)) -
                        centerRest;
    // v.v - r^2 in floats, and the errors of its sums and products.
    precise vec3 squares = v * v;
    precise float rr = radius * radius;
    precise float sum1 = squares.x - rr;
    precise float sum2 = sum1 + squares.y;
    precise float sum3 = sum2 + squares.z;
    precise float sumErrors = sumError(squares.x, -rr, sum1) + sumError(sum1, squares.y, sum2) +
                              sumError(sum2, squares.z, sum3);
    precise float productErrors =
        productError(v.x, v.x, squares.x) + productError(v.y, v.y, squares.y) +
        productError(v.z, v.z, squares.z) - productError(radius, radius, rr);
    // All together, with what `rest` adds: 2 v.rest + rest.rest.
    precise float power = sum3 + (sumErrors + productErrors + dot(2.0 * v + rest, rest));
    float size = squares.x + squares.y + squares.z + rr + dot(abs(v), abs(center));
    return SpherePosition(v, power, GAMMA(8.0) * kUnitRoundoff * size);
}

/// Parameter of the first crossing, or kFar.
float intersectSphere(SpherePosition origin, vec3 d, float radius) {
    vec3 o = origin.fromCenter;
    float a = dot(d, d);
    float b = dot(o, d);
    // D near the surface, and from afar.
    vec3 moment = cross(o, d);
    float rr = radius * radius;
    float discriminant =
        origin.power < rr ? b * b - a * origin.power : rr * a - dot(moment, moment);
    float near, far;
    bool hit = quadraticRoots(a, b, origin.power, origin.powerError, discriminant, near, far);
    vec2 interval = vec2(min(near, far), max(near, far));
    return hit ? firstCrossing(interval) : kFar;
}

/// Distance from the point to the sphere along the outward normal: radius - |p - center|.
float distanceToSphere(SpherePosition p, float radius) {
    return -p.power / (radius + length(p.fromCenter));
}

/// Outward unit normal at a point near the sphere.
vec3 sphereNormal(SpherePosition p) {
    return p.fromCenter * inversesqrt(dot(p.fromCenter, p.fromCenter));
}

#endif
