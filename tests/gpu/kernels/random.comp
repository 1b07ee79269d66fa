#version 460
// The random numbers of core/random.glsl and core/sobol.glsl, from four words.
#extension GL_GOOGLE_include_directive : require

#include "core/sobol.glsl"
#include "gpu/kernels/random_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { uvec4 words[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestRandom randoms[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= words.length())
        return;
    uvec4 w = words[i];
    SampleId id = SampleId(w.xy, w.z, 7u);
    uvec4 ofBounce = uvec4(
        bounceDimension(w.x, kDimensionLight), bounceDimension(w.x, kDimensionBsdf),
        bounceDimension(w.x, kDimensionAlpha), bounceDimension(w.x, kDimensionMediumDistance));
    uvec4 others = uvec4(bounceDimension(w.x, kDimensionMediumPhase), kDimensionCamera,
                         kDimensionTime, kDimensionWavelength);
    randoms[i] = TestRandom(pcg4d(w), unitFloats(w), uniformRandom(id, w.w), sobolRandom(id, w.w),
                            ofBounce, others);
}
