// The rounding errors of sums and products, as floats. Exact if every operation rounds to nearest
// and nothing underflows; otherwise still far smaller than the sum or product.
#ifndef CALOTYPE_CORE_ERROR_FREE_GLSL
#define CALOTYPE_CORE_ERROR_FREE_GLSL

/// a + b - `sum`, which is fl(a + b) (Knuth 1969).
float sumError(float a, float b, float sum) {
    precise float bRounded = sum - a;
    precise float aRounded = sum - bRounded;
    precise float error = (a - aRounded) + (b - bRounded);
    return error;
}

/// The upper 12 bits of x; the rest of x fits into 12 bits too (Veltkamp 1968).
float upperHalf(float x) {
    precise float scaled = 4097.0 * x;
    precise float upper = scaled - (scaled - x);
    return upper;
}

/// a b - `product`, which is fl(a b) (Dekker 1971).
float productError(float a, float b, float product) {
    float a1 = upperHalf(a);
    float b1 = upperHalf(b);
    precise float a2 = a - a1;
    precise float b2 = b - b1;
    precise float error = ((a1 * b1 - product) + a1 * b2 + a2 * b1) + a2 * b2;
    return error;
}

/// a b - c d, with an error of about 2^-46 of the larger product.
float differenceOfProducts(float a, float b, float c, float d) {
    precise float ab = a * b;
    precise float cd = c * d;
    precise float difference = (ab - cd) + (productError(a, b, ab) - productError(c, d, cd));
    return difference;
}

#endif
