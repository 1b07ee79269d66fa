#version 460
// Rays inside a closed mesh, aimed at corners and at points of edges: how many find no surface.
// They are traced by the loops that the rendering kernels trace theirs with.
#extension GL_GOOGLE_include_directive : require
#extension GL_KHR_shader_subgroup_ballot : require

#include "core/random.glsl"
#include "core/warp.glsl"
#include "extremes/kernels/edge_ray_structs.h"
#include "kernels/lane_rays.glsl"

layout(local_size_x = 64) in;
layout(set = 0, binding = kBindingEdgeBatches) readonly buffer Inputs { EdgeBatch batches[]; };
layout(set = 0, binding = kBindingEdgeEscapes) writeonly buffer Outputs { EdgeEscapes escapes[]; };

Triangle someTriangle(EdgeBatch batch, float u) {
    return loadTriangle(min(uint(u * float(batch.triangleCount)), batch.triangleCount - 1u));
}

/// Between the centre and a point of the surface.
vec3 someOrigin(EdgeBatch batch, vec4 u) {
    Triangle triangle = someTriangle(batch, u.x);
    vec2 b = warpToTriangle(u.yz);
    vec3 onSurface =
        triangle.v0 + (b.x * (triangle.v1 - triangle.v0) + b.y * (triangle.v2 - triangle.v0));
    return batch.center + batch.innermost * u.w * (onSurface - batch.center);
}

/// A corner for every third ray, else a point of an edge.
vec3 someTarget(EdgeBatch batch, vec4 u) {
    Triangle triangle = someTriangle(batch, u.x);
    vec3 from = u.y < 0.333 ? triangle.v0 : u.y < 0.667 ? triangle.v1 : triangle.v2;
    vec3 to = u.y < 0.333 ? triangle.v1 : u.y < 0.667 ? triangle.v2 : triangle.v0;
    return u.z < 0.333 ? from : mix(from, to, u.w);
}

void main() {
    uint i = gl_GlobalInvocationID.x;
    bool isActive = i < batches.length();
    EdgeBatch batch = batches[isActive ? i : 0u];
    EdgeEscapes result = EdgeEscapes(vec3(0.0), 0u, vec3(0.0), 0u);
    IterationCount count = IterationCount(0u, ~0u);
    for (uint number = 0u; number < kRaysPerEdgeBatch; ++number) {
        SampleId id = SampleId(uvec2(i & 0xFFFFu, i >> 16u), number, batch.seed);
        vec3 origin = someOrigin(batch, uniformRandom(id, 0u));
        vec3 direction = someTarget(batch, uniformRandom(id, 1u)) - origin;
        direction = batch.hasUnitRays != 0u ? normalize(direction) : direction;
        Hit hit = traceRay(Ray(origin, kFar, direction), isActive, false, kNone, count);
        bool escaped = hit.primitive == kNone;
        result.count += escaped ? 1u : 0u;
        result.origin = escaped ? origin : result.origin;
        result.direction = escaped ? direction : result.direction;
        countIteration(count);
    }
    result.iterations = count.passes;
    if (isActive)
        escapes[i] = result;
}
