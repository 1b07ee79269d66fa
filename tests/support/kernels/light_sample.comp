#version 460
// Points on lights, their densities, and the choice of a light.
#extension GL_GOOGLE_include_directive : require

#include "lights/light.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestLightQuery queries[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs {
    TestLightSample samples[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length())
        return;
    TestLightQuery query = queries[i];
    Light light = loadLight(query.light);
    SurfaceSample point = sampleLight(light, query.reference, query.u.xy);
    float pdf = lightPdf(light, query.reference, point.position, point.normal);
    vec3 emitted = emittedRadiance(light, point.normal, query.reference - point.position);
    LightChoice choice = chooseLight(query.lightCount, query.u.zw);
    samples[i] = TestLightSample(point.position, point.error, point.normal, point.pdf, pdf,
                                 choice.light, 0u, 0u, vec4(emitted, 0.0));
}
