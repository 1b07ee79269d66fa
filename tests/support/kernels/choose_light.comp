#version 460
// The light that two random numbers choose, the place on it, and the probabilities of this light
// and of a given one.
#extension GL_GOOGLE_include_directive : require

#include "lights/light.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestChoiceQuery queries[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs {
    TestLightChoice choices[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length())
        return;
    TestChoiceQuery query = queries[i];
    SceneLights lights = SceneLights(query.lightCount, query.infiniteLight, query.lightTreeDepth);
    LightChoice choice = chooseLight(lights, LitPoint(query.shadingPoint, query.normal), query.u);
    float given = probabilityOf(lights, loadLight(query.light), query.shadingPoint);
    choices[i] = TestLightChoice(choice.index, choice.u, choice.probability,
                                 choice.probabilityForMis, given, 0u, 0u, 0u);
}
