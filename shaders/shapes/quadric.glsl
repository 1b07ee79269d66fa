// The complete list of quadrics and disks: intersection, surface point and normal by kind.
#ifndef CALOTYPE_SHAPES_QUADRIC_GLSL
#define CALOTYPE_SHAPES_QUADRIC_GLSL

#include "config/features.glsl"
#include "core/select.glsl"
#include "shapes/cone.glsl"
#include "shapes/cylinder.glsl"
#include "shapes/disk.glsl"
#include "shapes/sphere.glsl"
#include "shared/scene_structs.h"

mat3 worldFromQuadric(Quadric quadric) { return mat3(quadric.axisX, quadric.axisY, quadric.axisZ); }

SpherePosition positionOnSphere(Quadric sphere, vec3 p) {
    return spherePosition(p, sphere.center, sphere.centerRest, sphere.radius);
}

/// Parameter of the first crossing along origin + t direction, or kFar.
float intersectQuadric(Quadric quadric, vec3 origin, vec3 direction) {
    if (hasSpheres && quadric.kind == kSphere)
        return intersectSphere(positionOnSphere(quadric, origin), direction, quadric.radius);
    LocalRay ray = localRay(origin, direction, quadric.center, worldFromQuadric(quadric));
    if (hasCylinders && quadric.kind == kCylinder)
        return intersectCylinder(ray, quadric.radius, quadric.extent);
    if (hasCones && quadric.kind == kCone)
        return intersectCone(ray, quadric.extent, quadric.slope);
    if (hasDisks && quadric.kind == kDisk)
        return intersectDisk(ray, quadric.radius);
    return kFar;
}

/// A point on a quadric, in the world.
struct QuadricPoint {
    vec3 position;
    float error; ///< bound on the distance along `normal` between `position` and the true surface
    vec3 normal; ///< outward; along the axis for a disk
};

/// The point of a sphere nearest to `p`, both in world space. Its error: that of the distance to
/// the surface, and one rounding each for the product with the normal and for the sum.
QuadricPoint spherePoint(Quadric sphere, vec3 p) {
    SpherePosition at = positionOnSphere(sphere, p);
    float correction = distanceToSphere(at, sphere.radius);
    QuadricPoint point;
    point.normal = sphereNormal(at);
    point.position = p + correction * point.normal;
    point.error = dot(abs(point.normal), GAMMA(2.0) * abs(point.position)) +
                  GAMMA(8.0) * abs(correction) + at.powerError / sphere.radius;
    return point;
}

/// The least distance of points from the rims of a solid. A point is moved off its face by its
/// error; a ray from there must still find it on the inner side of the other face. Where the faces
/// meet at a right angle, that takes 32 roundings of the solid's size and eight of its coordinates.
/// Base and side of a cone of slope k meet at an angle alpha with 1 / tan(alpha / 2) =
/// k + sqrt(1 + k^2): so many times a distance d from the rim, a point is inside both by d. The
/// roundings above are enough up to a factor of 2. What a sharp rim and coordinates take is at most
/// a 64th of the face, so that points of flat or far solids do not move visibly.
float rimMargin(Quadric quadric) {
    vec3 center = abs(quadric.center);
    float height = abs(quadric.extent);
    float slope = hasCones && quadric.kind == kCone ? quadric.slope : 0.0;
    float sharpness = max(1.0, 0.5 * (slope + sqrt(1.0 + slope * slope)));
    float ofSize = GAMMA(32.0) * (quadric.radius + height);
    float ofCoordinates = GAMMA(8.0) * (center.x + center.y + center.z);
    return ofSize + lesser((sharpness - 1.0) * ofSize + sharpness * ofCoordinates,
                           0.015625 * lesser(quadric.radius, max(1.0, slope) * height));
}

/// What `error`, a vector of bounds along the axes, may add to the distance from a face of radius
/// `radius`, beyond the part along the normal. Moved across the normal by e, a point is farther by
/// sqrt(radius^2 + e^2) - radius <= min(e, e^2 / (2 radius)) <= e^2 / (radius + e / 2).
/// The 1e-30 metres keep 0 / 0 from being NaN; no rounding of a coordinate is so small.
float errorAcrossNormal(vec3 error, float radius) {
    float square = dot(error, error);
    return square / max(radius + 0.5 * sqrt(square), 1e-30);
}

/// The surface point nearest to `p`, which is in the quadric's frame. Error: projection and
/// rotation take at most eight operations on numbers no larger than the shape; the sum with the
/// centre adds one on its coordinates. Near an apex, or on a cylinder as thin as the error itself,
/// the surface bends away within the error.
QuadricPoint quadricPoint(Quadric quadric, vec3 p) {
    mat3 worldFromLocal = worldFromQuadric(quadric);
    if (hasSpheres && quadric.kind == kSphere)
        return spherePoint(quadric,
                           quadric.center +
                               worldFromLocal * (p * (quadric.radius * inversesqrt(dot(p, p)))));
    vec3 normal = vec3(0.0, 1.0, 0.0);
    if (hasCylinders && quadric.kind == kCylinder) {
        normal = cylinderNormal(p, quadric.radius, quadric.extent);
        p = projectOntoCylinder(p, quadric.radius, quadric.extent, rimMargin(quadric));
    } else if (hasCones && quadric.kind == kCone) {
        normal = coneNormal(p, quadric.extent, quadric.slope);
        p = projectOntoCone(p, quadric.extent, quadric.slope, rimMargin(quadric));
    } else {
        p.y = 0.0;
    }
    // Precise: compiled for disks only, p.y is 0, and the sum must keep its order.
    precise vec3 offset = worldFromLocal * p;
    QuadricPoint point;
    point.position = quadric.center + offset;
    point.normal = normalize(worldFromLocal * normal);
    vec3 magnitude =
        abs(worldFromLocal[0] * p.x) + abs(worldFromLocal[1] * p.y) + abs(worldFromLocal[2] * p.z);
    vec3 error = GAMMA(12.0) * magnitude + GAMMA(2.0) * abs(point.position);
    point.error = dot(abs(point.normal), error);
    if ((hasCylinders || hasCones) && dot(normal.xz, normal.xz) > 0.0)
        point.error += errorAcrossNormal(error, length(p.xz));
    return point;
}

#endif
