// Sine and cosine to a few ULP: GLSL's own have an absolute error of up to 2^-11.
#ifndef CALOTYPE_CORE_TRIGONOMETRY_GLSL
#define CALOTYPE_CORE_TRIGONOMETRY_GLSL

/// (sin, cos) of 2 pi u, for u in [0, 1]. The angle is reduced to [-pi/4, pi/4] about the nearest
/// quarter turn k. This is exact, because 4 u - k is. The polynomials are those of Cephes's sinf
/// and cosf (Moshier), with an absolute error below 1.2e-7 (2^-23).
vec2 sinCosTwoPi(float u) {
    // The angle less k quarter turns.
    float quarterTurns = floor(4.0 * u + 0.5);
    float x = (4.0 * u - quarterTurns) * 1.57079632679490;
    float x2 = x * x;
    // Sine and cosine of what is left.
    float s = x + x * x2 * (-1.6666654611e-1 + x2 * (8.3321608736e-3 - x2 * 1.9515295891e-4));
    float c =
        1.0 - 0.5 * x2 +
        x2 * x2 * (4.166664568298827e-2 + x2 * (-1.388731625493765e-3 + x2 * 2.443315711809948e-5));
    // Turned back by k quarter turns: exchanged where k is odd, with the signs of the quadrant.
    uint k = uint(quarterTurns) & 3u;
    vec2 sc = (k & 1u) == 0u ? vec2(s, c) : vec2(c, s);
    return vec2(k >= 2u ? -sc.x : sc.x, k == 1u || k == 2u ? -sc.y : sc.y);
}

/// The angle of (x, y) from the x axis in turns, in [0, 1); 0 if both are zero. The arc tangent is
/// Cephes's atanf (Moshier), for ratios up to tan(pi / 8), after a rotation of the octant. The
/// error is below 1e-7 turns. GLSL's own may be off by 4096 ULP.
float angleInTurns(float x, float y) {
    // The ratio of the sides, in the half octant next to the x axis or to the diagonal.
    float larger = max(abs(x), abs(y));
    float smaller = min(abs(x), abs(y));
    bool beyondEighth = smaller > 0.414213562 * larger;
    float numerator = beyondEighth ? smaller - larger : smaller;
    float denominator = beyondEighth ? smaller + larger : larger;
    float t = denominator > 0.0 ? numerator / denominator : 0.0;
    // Its arc tangent.
    float t2 = t * t;
    float angle =
        t + t * t2 *
                (-3.33329491539e-1 +
                 t2 * (1.99777106478e-1 + t2 * (-1.38776856032e-1 + t2 * 8.05374449538e-2)));
    // In turns, brought back to the octant, half and side that (x, y) is in.
    float turns = (beyondEighth ? 0.125 : 0.0) + angle * 0.159154943091895;
    turns = abs(y) > abs(x) ? 0.25 - turns : turns;
    turns = x < 0.0 ? 0.5 - turns : turns;
    turns = y < 0.0 ? 1.0 - turns : turns;
    return turns < 1.0 ? turns : 0.0;
}

#endif
