// log(1 + x) and exp(x) - 1 without cancellation. GLSL's own functions cancel near zero, where
// Vulkan guarantees an absolute error only.
#ifndef CALOTYPE_CORE_EXPONENTIAL_GLSL
#define CALOTYPE_CORE_EXPONENTIAL_GLSL

/// log(1 + x) for x >= 0. Up to 1 the series 2 artanh(s), s = x / (2 + x) <= 1/3; the first omitted
/// term is below 2e-7 of the sum.
float logOnePlus(float x) {
    float s = x / (2.0 + x);
    float s2 = s * s;
    float series =
        2.0 * s *
        (1.0 + s2 * (1.0 / 3.0 +
                     s2 * (1.0 / 5.0 + s2 * (1.0 / 7.0 + s2 * (1.0 / 9.0 + s2 * (1.0 / 11.0))))));
    return x < 1.0 ? series : log(1.0 + x);
}

/// exp(x) - 1 for x >= 0. Up to 1/2 Taylor's series; the first omitted term is below 2e-7 of the
/// sum.
float expMinusOne(float x) {
    float series =
        x *
        (1.0 +
         x * (1.0 / 2.0 +
              x * (1.0 / 6.0 +
                   x * (1.0 / 24.0 + x * (1.0 / 120.0 + x * (1.0 / 720.0 + x * (1.0 / 5040.0)))))));
    return x < 0.5 ? series : exp(x) - 1.0;
}

#endif
