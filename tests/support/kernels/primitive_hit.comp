#version 460
// One ray against one primitive, and the surface at its hit.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "scene/interaction.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestRay rays[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { TestHit hits[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.length())
        return;
    TestRay test = rays[i];
    Ray ray = Ray(test.origin, test.tMax, test.direction);
    ShearedRay sheared = shearedRay(ray.origin, ray.direction);
    Hit hit = crossPrimitive(test.primitive, ray, sheared);
    Interaction surface = interactionAt(hit, ray);
    vec2 barycentrics = vec2(0.0);
    if ((test.primitive & kQuadricBit) == 0u) {
        Triangle triangle = loadTriangle(test.primitive);
        barycentrics = triangleBarycentrics(sheared, triangle);
    }
    hits[i] = TestHit(surface.position, hit.t, surface.ng, surface.error, surface.ns, surface.id,
                      barycentrics.x, barycentrics.y, hit.primitive, 0u);
}
