// Watertight triangles (Woop, Benthin and Wald 2013, "Watertight Ray/Triangle Intersection").
//
// The corners, seen from the ray's origin, are sheared so that the ray becomes the z axis; the
// triangle is hit where the origin of the xy plane lies inside its projection, by the signs of
// three edge functions. Two triangles that share an edge compute the same products for it,
// subtracted the other way round: `precise` forbids a fused multiply-add, whose two roundings would
// differ, so the signs are opposite or both zero, and zero counts as inside for both. No ray passes
// between them. There is no threshold on the determinant: small triangles are not lost.
//
// Error of t. With u the unit roundoff, X, Y and Z the largest |x'|, |y'| and |z| of the corners,
// and barycentric weights b_i = e_i / sum e_i, all of one sign for a hit:
//   - z: a difference and the scaling by 1 / dz, averaged by the weights, and the final sum:
//     gamma_8 Z / |dz|;
//   - the edge functions: x' is off by dX = gamma_6 (X + Z) at most, since |shear| <= 1, and y' by
//     dY alike; so |de| <= 2 (dX Y + dY X + dX dY + gamma_2 X Y). A weight's error moves t by the
//     range of z at most: 3 |de| (max z - min z) / |sum e|.
// A hit counts only beyond that bound, so a ray does not meet the triangle that it leaves.
#ifndef CALOTYPE_SHAPES_TRIANGLE_GLSL
#define CALOTYPE_SHAPES_TRIANGLE_GLSL

#include "core/constants.glsl"
#include "core/rounding.glsl"
#include "core/select.glsl"

/// A ray prepared for many triangles: its longest axis becomes z, the other two follow in turn.
struct ShearedRay {
    vec3 origin;
    vec3 shear; ///< direction.xy / direction.z and 1 / direction.z, after the turn of axes
    uint axis;  ///< 0, 1 or 2: the one of largest |direction|, the first of equals
};

struct TriangleHit {
    float t;           ///< kFar where the triangle is missed
    vec2 barycentrics; ///< weights of the second and third corner
};

vec3 turnAxes(vec3 v, uint axis) { return axis == 0u ? v.yzx : axis == 1u ? v.zxy : v; }

ShearedRay shearedRay(vec3 origin, vec3 direction) {
    vec3 length = abs(direction);
    ShearedRay ray;
    ray.origin = origin;
    ray.axis = length.x >= length.y && length.x >= length.z ? 0u : length.y >= length.z ? 1u : 2u;
    vec3 d = turnAxes(direction, ray.axis);
    precise vec3 shear = vec3(d.xy / d.z, 1.0 / d.z);
    ray.shear = shear;
    return ray;
}

TriangleHit intersectTriangle(ShearedRay ray, vec3 v0, vec3 v1, vec3 v2) {
    precise vec3 a = turnAxes(v0 - ray.origin, ray.axis);
    precise vec3 b = turnAxes(v1 - ray.origin, ray.axis);
    precise vec3 c = turnAxes(v2 - ray.origin, ray.axis);
    precise vec2 pa = a.xy - ray.shear.xy * a.z;
    precise vec2 pb = b.xy - ray.shear.xy * b.z;
    precise vec2 pc = c.xy - ray.shear.xy * c.z;
    precise float e0 = pc.x * pb.y - pc.y * pb.x;
    precise float e1 = pa.x * pc.y - pa.y * pc.x;
    precise float e2 = pb.x * pa.y - pb.y * pa.x;
    vec3 e = vec3(e0, e1, e2);
    float determinant = e0 + e1 + e2;
    bool inside = (least(e) >= 0.0 || greatest(e) <= 0.0) && determinant != 0.0;

    vec3 z = ray.shear.z * vec3(a.z, b.z, c.z);
    float inverse = inside ? 1.0 / determinant : 0.0;
    float t = dot(e, z) * inverse;

    float zMax = greatest(abs(vec3(a.z, b.z, c.z)));
    vec2 pMax = greater(greater(abs(pa), abs(pb)), abs(pc));
    vec2 pError = GAMMA(6.0) * (pMax + zMax);
    float eError =
        2.0 * ((pMax.x + pError.x) * pError.y + (GAMMA(2.0) * pMax.x + pError.x) * pMax.y);
    float zRange = greatest(z) - least(z);
    float tError = GAMMA(8.0) * zMax * abs(ray.shear.z) + 3.0 * eError * zRange * abs(inverse);
    TriangleHit hit;
    hit.t = inside && t > tError ? t : kFar;
    hit.barycentrics = vec2(e1, e2) * inverse;
    return hit;
}

#endif
