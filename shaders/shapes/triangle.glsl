// Watertight triangles (Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection").
//
// The corners are moved to the ray's origin and sheared so that the ray becomes the z axis. The ray
// hits the triangle if the origin of the xy plane is in its projection, by the signs of three edge
// functions. Two triangles that share an edge compute the same products for it, subtracted in
// opposite order. `precise` forbids fused multiply-adds, which would round differently. So the
// signs are opposite or both zero, and zero counts as inside: no ray passes between them. Rounding
// never reverses a sign, but may make all three zero for a sliver; then the remaining test is that
// the origin is in the bounding box of the projection, which holds for every triangle that contains
// it. There is no threshold on the determinant: small triangles are not lost.
//
// Whether the hit is ahead of the origin is decided by the plane: with the unit normal n and s the
// vector from the origin to a corner, t = n.s / n.d. The host rounds n once, so n.s has an error of
// gamma_5 of |n|.|s| (n, a difference, a product and two sums), and n.d of gamma_4 of |n|.|d|. If
// both are larger than that, their signs are certain: a ray does not hit the plane that it leaves,
// and a hit is not lost, however thin the triangle is. Otherwise the origin is in the plane, or the
// ray runs along it, within float precision; then the hit counts if all of the triangle is ahead.
// The hit is a mean of the corners, so t is clamped to their range.
#ifndef CALOTYPE_SHAPES_TRIANGLE_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_GLSL

#include "core/constants.glsl"
#include "core/rounding.glsl"
#include "core/select.glsl"
#include "shapes/triangle_point.glsl"

/// A ray prepared for many triangles: its longest axis becomes z, and the other two follow in turn.
struct ShearedRay {
    vec3 origin;
    vec3 direction;
    vec3 shear; ///< direction.xy / direction.z and 1 / direction.z, after the axes are permuted
    uint axis;  ///< 0, 1 or 2: the axis of the largest |direction|, the first one if equal
};

vec3 turnAxes(vec3 v, uint axis) { return axis == 0u ? v.yzx : axis == 1u ? v.zxy : v; }

ShearedRay shearedRay(vec3 origin, vec3 direction) {
    vec3 length = abs(direction);
    ShearedRay ray;
    ray.origin = origin;
    ray.direction = direction;
    ray.axis = length.x >= length.y && length.x >= length.z ? 0u : length.y >= length.z ? 1u : 2u;
    vec3 d = turnAxes(direction, ray.axis);
    precise vec3 shear = vec3(d.xy / d.z, 1.0 / d.z);
    ray.shear = shear;
    return ray;
}

/// The corners in the frame of the ray: xy across it, z along its longest axis.
struct ShearedTriangle {
    vec2 a;
    vec2 b;
    vec2 c;
    vec3 z; ///< of the three corners, in units of the direction
};

ShearedTriangle shearTriangle(ShearedRay ray, Triangle triangle) {
    precise vec3 a = turnAxes(triangle.v0 - ray.origin, ray.axis);
    precise vec3 b = turnAxes(triangle.v1 - ray.origin, ray.axis);
    precise vec3 c = turnAxes(triangle.v2 - ray.origin, ray.axis);
    precise vec2 pa = a.xy - ray.shear.xy * a.z;
    precise vec2 pb = b.xy - ray.shear.xy * b.z;
    precise vec2 pc = c.xy - ray.shear.xy * c.z;
    return ShearedTriangle(pa, pb, pc, ray.shear.z * vec3(a.z, b.z, c.z));
}

/// Twice the signed areas that the ray spans with the edges opposite to the three corners.
vec3 edgeFunctions(vec2 a, vec2 b, vec2 c) {
    precise float e0 = c.x * b.y - c.y * b.x;
    precise float e1 = a.x * c.y - a.y * c.x;
    precise float e2 = b.x * a.y - b.y * a.x;
    return vec3(e0, e1, e2);
}

/// True if the ray is in the bounding box of the projected triangle.
bool isInBox(ShearedTriangle seen) {
    vec2 lower = lesser(lesser(seen.a, seen.b), seen.c);
    vec2 upper = greater(greater(seen.a, seen.b), seen.c);
    return greater(lower.x, lower.y) <= 0.0 && lesser(upper.x, upper.y) >= 0.0;
}

/// Parameter of the hit, or kFar.
float intersectTriangle(ShearedRay ray, Triangle triangle) {
    ShearedTriangle seen = shearTriangle(ray, triangle);
    vec3 e = edgeFunctions(seen.a, seen.b, seen.c);
    bool inside = (least(e) >= 0.0 || greatest(e) <= 0.0) && isInBox(seen);

    vec3 normal = normalOf(triangle);
    vec3 toPlane = triangle.v0 - ray.origin;
    float height = dot(normal, toPlane);
    float approach = dot(normal, ray.direction);
    vec3 magnitude = GAMMA(5.0) * abs(normal);
    bool isCertain = abs(height) > dot(magnitude, abs(toPlane)) &&
                     abs(approach) > dot(magnitude, abs(ray.direction));

    float nearest = least(seen.z);
    float farthest = greatest(seen.z);
    float t = greater(lesser(height / approach, farthest), nearest);
    bool allAhead = nearest > GAMMA(8.0) * farthest && e != vec3(0.0);
    bool ahead = isCertain ? (height > 0.0) == (approach > 0.0) : allAhead;
    return inside && ahead && t > 0.0 ? t : kFar;
}

#endif
