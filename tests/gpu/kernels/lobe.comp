#version 460
// One lobe of the closed list, by the functions of its contract. The event's `lobes` names it.
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
    SurfaceParameters surface =
        SurfaceParameters(event.lobes, event.color, event.roughness, event.specular, event.kd,
                          event.exponent, event.eta);
    vec3 u = vec3(event.u1, event.u2, event.u3);
    TestLobe result;
    if ((event.lobes & kLobeDiffuse) != 0u)
        CALOTYPE_TEST_LOBE(makeDiffuse(surface))
    else if ((event.lobes & kLobeGgx) != 0u)
        CALOTYPE_TEST_LOBE(makeGgx(surface))
    else if ((event.lobes & kLobeBlinnPhong) != 0u)
        CALOTYPE_TEST_LOBE(makeBlinnPhong(surface))
    else
        CALOTYPE_TEST_LOBE(makeDielectric(surface))
    results[i] = result;
}
