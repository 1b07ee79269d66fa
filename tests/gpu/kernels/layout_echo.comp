#version 460
// Every field of every shared struct, in the order of its declaration: the second element of each
// array of the scene, then what a dispatch is told.
#extension GL_GOOGLE_include_directive : require

#include "buffers/packed_scene.glsl"
#include "shared/layers.h"
#include "shared/ray_structs.h"
#include "shared/render_structs.h"
#include "support/kernels/test_structs.h"

layout(local_size_x = 1) in;
layout(push_constant) uniform Parameters {
    RenderParameters parameters;
    FirstHitParameters firstHitParameters;
};
layout(set = 0, binding = kBindingCamera) uniform CameraBlock { Camera camera; };
layout(set = 0, binding = kBindingCounters) readonly buffer CountersBlock {
    RenderCounters counters;
};
layout(set = 0, binding = kBindingFirstHits) readonly buffer FirstHits { uint firstHitWords[]; };
layout(set = 0, binding = kBindingParkedPaths) readonly buffer ParkedPaths {
    ParkedPath parkedPaths[];
};
layout(set = 0, binding = kBindingRays) readonly buffer Rays { ListedRay rays[]; };
layout(set = 0, binding = kBindingListedHits) readonly buffer ListedHits { ListedHit hits[]; };
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

void putTriangles() {
    Triangle t = loadTriangle(1u);
    put(t.v0);
    put(t.normalX);
    put(t.v1);
    put(t.normalY);
    put(t.v2);
    put(t.normalZ);
    put(t.material);
    put(t.light);
    put(t.id);
    put(t.pad0);
    TriangleNormals n = loadTriangleNormals(1u);
    put(n.n0);
    put(n.pad0);
    put(n.n1);
    put(n.pad1);
    put(n.n2);
    put(n.pad2);
    TriangleUvs u = loadTriangleUvs(1u);
    put(u.uv0);
    put(u.uv1);
    put(u.uv2);
    put(u.pad0);
    put(u.pad1);
}

void putQuadric() {
    Quadric q = loadQuadric(1u);
    put(q.center);
    put(q.radius);
    put(q.axisX);
    put(q.extent);
    put(q.axisY);
    put(q.kind);
    put(q.axisZ);
    put(q.slope);
    put(q.material);
    put(q.light);
    put(q.id);
    put(q.pad0);
    put(q.centerRest);
    put(q.pad1);
}

void putMaterial() {
    Material m = loadMaterial(1u);
    put(m.color);
    put(m.colorTexture);
    put(m.roughness);
    put(m.roughnessTexture);
    put(m.specular);
    put(m.specularTexture);
    put(m.lobes);
    put(m.normalMap);
    put(m.alphaTexture);
    put(m.opacity);
    put(m.kd);
    put(m.exponent);
    put(m.eta);
    put(m.pad0);
    Texture t = loadTexture(1u);
    put(t.scale);
    put(t.offset);
    put(t.firstRow);
    put(t.width);
    put(t.height);
    put(t.flags);
    put(t.color0);
    put(t.pad0);
    put(t.color1);
    put(t.pad1);
}

void putLight() {
    Light l = loadLight(1u);
    put(l.radiance);
    put(l.primitive);
    put(l.area);
    put(l.selectionProbability);
    put(l.firstNumber);
    put(l.ownNumbers);
    put(l.aliasNumbers);
    put(l.alias);
    put(l.flags);
    put(l.kind);
}

void putCamera() {
    put(camera.position);
    put(camera.focusDistance);
    put(camera.right);
    put(camera.isOrthographic);
    put(camera.up);
    put(camera.filterIsBox);
    put(camera.forward);
    put(camera.pad0);
    put(camera.lensRight);
    put(camera.pad1);
    put(camera.lensUp);
    put(camera.pad2);
}

void putParameters() {
    RenderParameters p = parameters;
    put(p.imageSize);
    put(p.cropOrigin);
    put(p.cropSize);
    put(p.firstTile);
    put(p.firstSample);
    put(p.sampleEnd);
    put(p.seed);
    put(p.maxBounces);
    put(p.lightCount);
    put(p.iterationBudget);
    put(p.indirectClamp);
    put(p.backgroundLight);
    put(p.pad0);
}

void putCounters() {
    put(counters.rays);
    put(counters.paths);
    put(counters.nonFiniteSamples);
    put(counters.cutPaths);
    put(counters.unfinishedPixels);
    put(counters.pad0);
    put(counters.pad1);
    put(counters.pad2);
}

void putFirstHit() {
    FirstHitParameters p = firstHitParameters;
    put(p.imageSize);
    put(p.cropOrigin);
    put(p.cropSize);
    put(p.firstTile);
    put(p.iterationsBeforeCut);
    for (uint i = 0u; i < kFirstHitWords; ++i)
        put(firstHitWords[kFirstHitWords + i]);
}

void putParkedPath() {
    ParkedPath p = parkedPaths[1];
    put(p.rayOrigin);
    put(p.rayTMax);
    put(p.rayDirection);
    put(p.target);
    put(p.vertex);
    put(p.bounce);
    put(p.throughput);
    put(p.bsdfPdf);
    put(p.radiance);
    put(p.etaScale);
    put(p.arriving);
    put(p.item);
    put(p.direction);
    put(p.nextItem);
}

void putRayList() {
    put(rays[1].origin);
    put(rays[1].tMax);
    put(rays[1].direction);
    put(rays[1].target);
    put(hits[1].t);
    put(hits[1].primitive);
}

void main() {
    BvhNode node = loadNode(1u);
    put(node.origin);
    put(node.nodesAndExponents);
    put(node.childBase);
    put(node.firstTriangle);
    put(node.firstQuadric);
    put(node.primitives);
    put(node.lowerX);
    put(node.upperX);
    put(node.lowerY);
    put(node.upperY);
    put(node.lowerZ);
    put(node.upperZ);
    putTriangles();
    putQuadric();
    putMaterial();
    putLight();
    for (uint step = 0u; step < 4u; ++step)
        put(loadFilterQuantile(step));
    putCamera();
    putParameters();
    putCounters();
    putFirstHit();
    putParkedPath();
    putRayList();
}
