#version 460
// One scattering event on a material.
#extension GL_GOOGLE_include_directive : require

#include "bsdf/bsdf.glsl"
#include "gpu/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestScattering events[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestScattered results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= events.length())
        return;
    TestScattering event = events[i];
    Material material = Material(event.color.rgb, 0u);
    Bsdf bsdf = makeBsdf(material, event.ng, event.ns, event.wo);
    BsdfSample scattered = sampleBsdf(bsdf, vec2(event.u1, event.u2));
    Bsdf reversed = makeBsdf(material, event.ng, event.ns, scattered.wi);
    results[i] = TestScattered(
        scattered.wi, scattered.pdf, scattered.weight, bsdfPdf(bsdf, scattered.wi),
        vec4(evaluateBsdf(bsdf, scattered.wi), 0.0), vec4(evaluateBsdf(reversed, event.wo), 0.0));
}
