#version 460
// Normals by normal maps, and bent to the viewer.
#extension GL_GOOGLE_include_directive : require

#include "bsdf/shading_normal.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestNormalMap queries[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestNormals results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length())
        return;
    TestNormalMap query = queries[i];
    vec3 mapped = mappedNormal(query.texel, query.n, query.dpdu, query.dpdv, query.ng);
    results[i] = TestNormals(mapped, 0.0, consistentNormal(query.wo, query.ng, query.n), 0.0);
}
