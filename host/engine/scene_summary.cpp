#include "engine/scene_summary.h"

#include <algorithm>

#include "engine/compile_scene.h"
#include "engine/device_session.h"
#include "render/path_tracer.h"
#include "scene/scene_bounds.h"
#include "shared/limits.h"

namespace calotype {
namespace {

/// The sums of the film for many samples, and the picture (docs/limitations.md).
constexpr uint64_t kHostBytesPerPixel = 80;

void addTree(SceneSummary& summary, const CompiledScene& compiled) {
    const BvhStatistics statistics = bvhStatistics(compiled.bvh);
    summary.builder = compiled.builder;
    summary.nodes = statistics.nodes;
    summary.childrenPerNode = statistics.childrenPerNode;
    summary.depth = compiled.bvh.depth;
    summary.mostDepth = shared::kMaxBvhDepth;
    summary.leaves = statistics.leaves;
    summary.primitivesPerLeaf = statistics.primitivesPerLeaf;
    summary.nodesVisited = statistics.nodesVisited;
    summary.primitivesVisited = statistics.primitivesVisited;
}

void addMemory(SceneSummary& summary, const GpuScene& packed) {
    summary.textureBytes = rowCount(packed.texelRows) * kBytesOfTexelRow;
    summary.sceneBytes = packed.bytes();
    summary.largestBytes = packed.largestBytes();
}

} // namespace

SceneSummary summarize(const Scene& scene, const RenderSettings& settings) {
    const CompiledScene compiled = compileScene(scene, settings);
    SceneSummary summary;
    summary.shapes = scene.shapes.size();
    summary.quadrics = static_cast<size_t>(
        std::ranges::count(compiled.primitives, PrimitiveKind::Quadric, &Primitive::kind));
    summary.triangles = compiled.primitives.size() - summary.quadrics;
    summary.materials = scene.materials.size();
    summary.textures = scene.textures.size();
    summary.lights = compiled.packed.lightCount;
    summary.droppedTriangles = scene.droppedTriangles;
    summary.bounds = sceneBounds(scene);
    addTree(summary, compiled);
    for (size_t i = 0; i < kFeatureNames.size(); ++i)
        if (compiled.packed.features.enabled[i])
            summary.features.emplace_back(kFeatureNames[i]);
    addMemory(summary, compiled.packed);
    return summary;
}

DeviceTextureMemory textureMemoryOf(const DeviceOptions& options) {
    const DeviceSession session(options);
    const Device& device = session.device();
    const uint64_t buffer = uint64_t{device.limits().maxTexelBufferElements} * 16;
    return {std::min(buffer, device.info().memoryBytes), device.info().name,
            device.info().type == "CPU"};
}

DeviceFit fitOf(const RenderSettings& settings, const DeviceOptions& options) {
    const DeviceSession session(options);
    const Device& device = session.device();
    const DeviceFit fit{device.info().name,
                        device.choice().reason,
                        pathTracerBytes(device, settings),
                        kHostBytesPerPixel * settings.width * settings.height,
                        device.info().memoryBytes,
                        uint64_t{device.limits().maxTexelBufferElements} * 16};
    session.throwOnValidationMessages();
    return fit;
}

} // namespace calotype
