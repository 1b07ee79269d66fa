#version 460
// Every field of every shared struct, in the order of its declaration: the second element of each
// array of the scene, then what a dispatch reads and what it writes.
#extension GL_GOOGLE_include_directive : require

#include "buffers/packed_scene.glsl"
#include "kernels/parked_tasks.glsl"
#include "shared/layers.h"
#include "shared/ray_structs.h"
#include "shared/render_structs.h"
#include "support/kernels/test_structs.h"

layout(local_size_x = 1) in;
layout(push_constant) uniform Parameters {
    RenderParameters parameters;
    RecordParameters recordParameters;
};
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingCounters) readonly buffer CountersBlock {
    RenderCounters counters;
};
layout(set = 0, binding = kBindingFirstHits) readonly buffer FirstHits { uint firstHitWords[]; };
layout(set = 0, binding = kBindingRays) readonly buffer Rays { ListedRay rays[]; };
layout(set = 0, binding = kBindingListedHits) readonly buffer ListedHits { ListedHit hits[]; };
layout(set = 0, binding = kBindingTestInputs) readonly buffer RayListBlock {
    RayListParameters rayListParameters;
};
layout(set = 0, binding = kBindingTestOutputs) writeonly buffer Outputs { uint words[]; };

uint count = 0u;

void put(uint x) { words[count++] = x; }
void put(float x) { put(floatBitsToUint(x)); }
void put(uvec2 v) {
    put(v.x);
    put(v.y);
}
void put(vec2 v) {
    put(v.x);
    put(v.y);
}
void put(vec3 v) {
    put(v.x);
    put(v.y);
    put(v.z);
}

#include "gpu/kernels/put_structs.h"
#include "shared/scene_struct_table.h"

#include "gpu/kernels/put_structs.h"
#include "shared/render_struct_table.h"

#include "gpu/kernels/put_structs.h"
#include "shared/ray_struct_table.h"

#include "gpu/kernels/put_structs.h"

#include "kernels/parked_task_table.h"

void main() {
#define BEGIN_BINDINGS
#define SCENE_ARRAY(id, type, member, people) put(load##type(1u));
#define SCENE_ROWS(id, type, member, people)
#define BINDING(id)
#define END_BINDINGS
#include "shared/binding_table.h"
    put(camera);
    put(parameters);
    put(recordParameters);
    put(rayListParameters);
    put(counters);
    for (uint i = 0u; i < kFirstHitWords; ++i)
        put(firstHitWords[kFirstHitWords + i]);
    storeParkedTask(0u, loadParkedTask(1u));
    put(loadParkedTask(0u));
    put(rays[1]);
    put(hits[1]);
}
