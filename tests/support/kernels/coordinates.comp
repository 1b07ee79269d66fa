#version 460
// One ray against one primitive, and the texture coordinates at its hit.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_arithmetic : require

#include "scene/interaction.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingTestInputs) readonly buffer Inputs { TestRay rays[]; };
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs {
    TestCoordinates results[];
};

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= rays.length())
        return;
    TestRay test = rays[i];
    Ray ray = Ray(test.origin, test.tMax, test.direction);
    Hit hit = crossPrimitive(test.primitive, ray, shearedRay(ray.origin, ray.direction));
    Interaction surface = interactionAt(hit, ray);
    SurfaceCoordinates at = surface.coordinates;
    results[i] = TestCoordinates(surface.position, at.uv.x, at.dpdu, at.uv.y, at.dpdv, hit.t);
}
