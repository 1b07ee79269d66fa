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
    LightSample chosen = sampleLight(light, query.shadingPoint, query.u.xy);
    LightPoint point = chosen.point;
    float pdf = finiteLightPdf(light, query.shadingPoint, point);
    vec3 emitted = finiteLightRadiance(light, point);
    SceneLights lights = SceneLights(query.lightCount, kNone, 0u);
    LightChoice choice = chooseLight(lights, LitPoint(query.shadingPoint, vec3(0.0)), query.u.zw);
    samples[i] = TestLightSample(point.position, point.error, point.normal, chosen.pdf, pdf,
                                 choice.index, 0u, 0u, vec4(emitted, 0.0));
}
