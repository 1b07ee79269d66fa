// How a path's random numbers are drawn, as the kernel was specialised.
#ifndef CALOTYPE_CONFIG_SAMPLER_GLSL
#define CALOTYPE_CONFIG_SAMPLER_GLSL

#include "config/settings.glsl"
#include "core/sobol.glsl"

/// Four numbers in [0, 1) for one of the path's dimensions.
vec4 samplerNumbers(SampleId id, uint dimension) {
    return usesSobol ? sobolRandom(id, dimension) : uniformRandom(id, dimension);
}

#endif
