// The random numbers of a path, from the sampler that the kernel is specialised for.
#ifndef CALOTYPE_CONFIG_SAMPLER_GLSL
#define CALOTYPE_CONFIG_SAMPLER_GLSL

#include "config/settings.glsl"
#include "core/sobol.glsl"

/// Four numbers in [0, 1) for one of the path's dimensions.
vec4 samplerNumbers(SampleId id, uint dimension) {
    return usesSobol ? sobolRandom(id, dimension) : uniformRandom(id, dimension);
}

#endif
