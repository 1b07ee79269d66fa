// Where a line enters and leaves { f <= 0 }, for f(t) = a t^2 + 2 b t + c along the line.
//
// The textbook roots (-b +- sqrt(D)) / a cancel if b^2 >> a c. With
//     q = -(b + sign(b) sqrt(D)),
// both terms have the same sign. The roots are q / a and c / q; neither cancels, and c / q is the
// one nearer to the origin.
//
// D = b^2 - a c itself cancels for far origins, so each shape computes it from the moment origin x
// direction, which does not depend on where along the line the origin is (Lagrange's identity;
// similar to the residual vector of Haines et al. 2019, Ray Tracing Gems ch. 7).
//
// Rays that start on the surface: |c| <= cError there, and the sign of c is noise. Then the near
// root is set to exactly 0, which no ray accepts, and the other to -2 b / a. If the origin is
// certainly outside (c > cError) or inside (c < -cError), the signs of the roots follow from signs
// alone. So rounding cannot make a ray hit the surface that it has just left.
#ifndef CALOTYPE_SHAPES_QUADRATIC_GLSL
#define CALOTYPE_SHAPES_QUADRATIC_GLSL

#include "core/constants.glsl"

/// The two roots, first the one nearer to the origin. False if the line misses and there is none.
/// `discriminant` is b^2 - a c, computed in a stable way. If a root must exist in exact arithmetic
/// (the origin is on the surface or inside it, or a <= 0, which only a cone's double nappe has),
/// rounding cannot remove it.
bool quadraticRoots(float a, float b, float c, float cError, float discriminant, out float near,
                    out float far) {
    bool onSurface = abs(c) <= cError;
    bool inside = c < 0.0 && a > 0.0;
    float d = onSurface ? b * b : inside ? max(discriminant, b * b) : discriminant;
    d = a <= 0.0 ? max(d, 0.0) : d;
    float root = sqrt(max(d, 0.0));
    float q = -(b + (b < 0.0 ? -root : root));
    near = onSurface || q == 0.0 ? 0.0 : c / q;
    far = q / a;
    return d >= 0.0;
}

#endif
