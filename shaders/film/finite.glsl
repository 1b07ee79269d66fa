// Tests for NaN and infinity by bits: isnan and isinf may be optimised away.
#ifndef CALOTYPE_FILM_FINITE_GLSL
#define CALOTYPE_FILM_FINITE_GLSL

bool isFinite(float x) { return (floatBitsToUint(x) & 0x7F800000u) != 0x7F800000u; }

bool isFinite(vec3 v) { return isFinite(v.x) && isFinite(v.y) && isFinite(v.z); }

#endif
