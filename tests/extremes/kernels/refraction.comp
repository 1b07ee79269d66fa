#version 460
// Fresnel reflectances and refracted cosines of directions in the plane y = 0.
#extension GL_GOOGLE_include_directive : require

#include "bsdf/fresnel.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { vec4 queries[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { vec2 results[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length())
        return;
    vec3 query = queries[i].xyz; // sine, cosine, index of refraction
    Refraction refraction = refractDielectric(vec3(query.x, 0.0, query.y), query.z);
    results[i] = vec2(refraction.reflectance, refraction.cosThetaT);
}
