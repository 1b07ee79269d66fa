// The material of a test's scattering event.
#ifndef CALOTYPE_TEST_SURFACE_GLSL
#define CALOTYPE_TEST_SURFACE_GLSL

#include "bsdf/surface_parameters.glsl"
#include "support/kernels/test_structs.h"

SurfaceParameters surfaceOf(TestScattering event) {
    return SurfaceParameters(event.lobes, event.color, event.roughness, event.specular, event.kd,
                             event.exponent, event.eta);
}

#endif
