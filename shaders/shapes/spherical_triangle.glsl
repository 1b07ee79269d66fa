// Triangles as seen from a point: their solid angle, and points that are uniform in it
// (docs/models.md, "Triangle light").
#ifndef CALOTYPE_SHAPES_SPHERICAL_TRIANGLE_GLSL
#define CALOTYPE_SHAPES_SPHERICAL_TRIANGLE_GLSL

#include "core/constants.glsl"
#include "core/select.glsl"
#include "core/trigonometry.glsl"
#include "shapes/triangle_point.glsl"

/// The projection of a triangle onto the unit sphere around a point.
struct SphericalTriangle {
    vec3 a; ///< unit directions to the corners v0, v1 and v2
    vec3 b;
    vec3 c;
    vec3 inverseDistances; ///< of the corners, 1/m
    float determinant;     ///< |a . (b x c)|
    float halfAngle;       ///< half of the solid angle, in turns: at most 1/2
};

/// 1 + cosine of the angle between two unit vectors, also accurate near 0.
float onePlusCosine(vec3 v, vec3 w) {
    vec3 sum = v + w;
    return 0.5 * dot(sum, sum);
}

/// `area` is the triangle's, m^2.
SphericalTriangle sphericalTriangle(Triangle triangle, float area, vec3 point) {
    const float kSmallestSquare = 1.2e-38; // so that no distance is zero
    vec3 toA = triangle.v0 - point;
    vec3 toB = triangle.v1 - point;
    vec3 toC = triangle.v2 - point;
    vec3 squares = vec3(dot(toA, toA), dot(toB, toB), dot(toC, toC));
    SphericalTriangle seen;
    seen.inverseDistances = inversesqrt(greater(squares, vec3(kSmallestSquare)));
    seen.a = toA * seen.inverseDistances.x;
    seen.b = toB * seen.inverseDistances.y;
    seen.c = toC * seen.inverseDistances.z;
    seen.determinant = 2.0 * area * seen.inverseDistances.y * seen.inverseDistances.z *
                       abs(dot(normalOf(triangle), seen.a));
    float cosines = dot(seen.a + seen.b, seen.c) + onePlusCosine(seen.a, seen.b);
    seen.halfAngle = angleInTurns(cosines, seen.determinant);
    return seen;
}

/// In steradians.
float solidAngleOf(SphericalTriangle seen) { return 2.0 * kTwoPi * seen.halfAngle; }

/// Whether points can be sampled by solid angle in single precision.
bool canSampleSolidAngle(SphericalTriangle seen) {
    const float kLeastDeterminant = 7.1e-15;          // 2^-47
    const float kLargestHalfAngle = 0.5 - 0.00497359; // of a solid angle of 2 pi - 1/16
    return seen.determinant >= kLeastDeterminant && seen.halfAngle <= kLargestHalfAngle;
}

/// Barycentric weights of the second and third corner, of a point that is uniform in the solid
/// angle. canSampleSolidAngle holds.
vec2 uniformInSolidAngle(SphericalTriangle seen, vec2 u) {
    // The point p on the edge from b to c: the triangle a b p has the share u.y of the solid angle.
    // It is b, mirrored about mb b + mc c, which is m / D of docs/models.md.
    vec2 sinCos = sinCosTwoPi(u.y * seen.halfAngle);
    float scale = sinCos.x / seen.determinant;
    float mc = scale * onePlusCosine(seen.a, seen.b);
    float difference = sinCos.y - scale * dot(seen.a + seen.b, seen.c) - mc; // mb - mc
    float edge = onePlusCosine(seen.b, seen.c);
    float bm = difference + mc * edge; // b . m
    // 1e-30, a squared length of weights: against 0 / 0 alone.
    float perSquare = 1.0 / greater(bm * bm + mc * mc * edge * (2.0 - edge), 1e-30);
    float pb = difference * (difference + 2.0 * mc) * perSquare;
    float pc = 2.0 * mc * bm * perSquare;
    // The direction on the arc from a to p. 1 - its cosine with a is the share u.x of that of p.
    // 1e-14 is the square of the rounding of unit vectors, 2^-23.
    float arc = lesser(greater(onePlusCosine(seen.a, pb * seen.b + pc * seen.c), 1e-14), 2.0);
    float oneMinusCos = u.x * (2.0 - arc);
    float alongP = sqrt(u.x * (2.0 - oneMinusCos) / arc);
    vec3 direction = vec3(1.0 - oneMinusCos + alongP * (1.0 - arc), alongP * pb, alongP * pc);
    // The weights of corners are those of unit vectors over their distances.
    vec3 weights = greater(direction, vec3(0.0)) * seen.inverseDistances;
    return weights.yz * (1.0 / (weights.x + weights.y + weights.z));
}

#endif
