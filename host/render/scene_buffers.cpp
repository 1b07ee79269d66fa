#include "render/scene_buffers.h"

#include <span>

#include "shared/bindings.h"

namespace calotype {
namespace {

template <typename T>
std::span<const std::byte> bytesOf(const std::vector<T>& array) {
    return std::as_bytes(std::span(array));
}

} // namespace

SceneBuffers::SceneBuffers(const Device& device, const GpuScene& scene)
    : nodes_(device, bytesOf(scene.nodes), "BVH nodes"),
      triangles_(device, bytesOf(scene.triangles), "triangles"),
      triangleNormals_(device, bytesOf(scene.triangleNormals), "triangle normals"),
      quadrics_(device, bytesOf(scene.quadrics), "quadrics"),
      materials_(device, bytesOf(scene.materials), "materials"),
      lights_(device, bytesOf(scene.lights), "lights") {}

std::vector<Binding> SceneBuffers::bindings() const {
    return {
        Binding::texelBuffer(gpu::kBindingNodes, nodes_),
        Binding::texelBuffer(gpu::kBindingTriangles, triangles_),
        Binding::texelBuffer(gpu::kBindingTriangleNormals, triangleNormals_),
        Binding::texelBuffer(gpu::kBindingQuadrics, quadrics_),
        Binding::texelBuffer(gpu::kBindingMaterials, materials_),
        Binding::texelBuffer(gpu::kBindingLights, lights_),
    };
}

} // namespace calotype
