#version 460
// One scattering event on a material, and its value at a direction of the test's choice.
#extension GL_GOOGLE_include_directive : require

#include "bsdf/bsdf.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestScattering events[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestScattered results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= events.length())
        return;
    TestScattering event = events[i];
    Bsdf bsdf = makeBsdf(event.material, event.ng, event.ns, event.ng, event.wo);
    BsdfSample scattered = sampleBsdf(bsdf, vec3(event.u1, event.u2, event.u3));
    BsdfValue again = evaluateBsdf(bsdf, scattered.wi);
    BsdfValue given = evaluateBsdf(bsdf, event.wi);
    results[i] = TestScattered(scattered.wi, scattered.pdf, scattered.weight, again.pdf,
                               again.value, scattered.crosses ? 1u : 0u, given.value, given.pdf,
                               bsdf.worldFromShading[2], bsdf.diffuseShare.chance);
}
