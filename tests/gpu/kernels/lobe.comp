#version 460
// One lobe of the closed list, by the functions of its contract. The event's material names it.
#extension GL_GOOGLE_include_directive : require

#include "bsdf/bsdf.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestScattering events[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestLobe results[]; };

#define CALOTYPE_TEST_LOBE(lobe)                                                                   \
    {                                                                                              \
        LobeSample drawn = sampleLobe(lobe, event.wo, u);                                          \
        result = TestLobe(                                                                         \
            drawn.wi, lobePdf(lobe, event.wo, drawn.wi), evaluateLobe(lobe, event.wo, drawn.wi),   \
            lobeAlbedo(lobe, event.wo), drawn.specularWeight, drawn.isSpecular ? 1u : 0u,          \
            evaluateLobe(lobe, event.wo, event.wi), lobePdf(lobe, event.wo, event.wi),             \
            isSpecular(lobe) ? 1u : 0u, drawn.eta, 0u, 0u);                                        \
    }

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= events.length())
        return;
    TestScattering event = events[i];
    vec3 u = vec3(event.u1, event.u2, event.u3);
    TestLobe result;
#define LOBE(id, member, people)                                                                   \
    if ((event.material.lobes & kLobe##id) != 0u)                                                  \
    CALOTYPE_TEST_LOBE(make##id(event.material))
#include "shared/feature_table.h"
    results[i] = result;
}
