#version 460
// Camera rays.
#extension GL_GOOGLE_include_directive : require

#include "path/camera.glsl"
#include "support/kernels/test_structs.h"

layout(local_size_x = 64) in;
layout(set = 0, binding = 0) readonly buffer Inputs { TestFilmQuery queries[]; };
layout(set = 0, binding = 1) writeonly buffer Outputs { TestCameraRay rays[]; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i >= queries.length())
        return;
    TestFilmQuery query = queries[i];
    Ray ray = cameraRay(query.camera, query.position, query.imageSize, query.u);
    rays[i] = TestCameraRay(ray.origin, ray.tMax, ray.direction, 0.0);
}
