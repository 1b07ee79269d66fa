// What kernels/random.comp gives back for four words w.
#ifndef CALOTYPE_TEST_RANDOM_STRUCTS_H
#define CALOTYPE_TEST_RANDOM_STRUCTS_H

#include "shared/types.h"

CALOTYPE_BEGIN_SHARED

struct TestRandom {
    uvec4 hash;             ///< pcg4d(w)
    vec4 units;             ///< unitFloats(w)
    vec4 uniforms;          ///< uniformRandom of pixel w.xy, sample w.z, dimension w.w, seed 7
    vec4 sobol;             ///< sobolRandom of the same
    uvec4 bounceDimensions; ///< of bounce w.x: light, BSDF, alpha, medium distance
    uvec4 otherDimensions;  ///< medium phase of bounce w.x; camera, time, wavelength
};

CALOTYPE_END_SHARED

#endif
