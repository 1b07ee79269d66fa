// Multiple importance sampling of two strategies with one sample each.
#ifndef CALOTYPE_PATH_MIS_GLSL
#define CALOTYPE_PATH_MIS_GLSL

/// Power heuristic with exponent 2 (Veach 1997, section 9.2.2), as 1 / (1 + (b / a)^2): this form
/// squares no density, so it does not overflow. `pdf` is the density of the strategy that was used
/// and is above 0; both are per solid angle.
float misWeight(float pdf, float otherPdf) {
    float ratio = otherPdf / pdf;
    return 1.0 / (1.0 + ratio * ratio);
}

#endif
