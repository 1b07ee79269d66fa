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
      triangleUvs_(device, bytesOf(scene.triangleUvs), "texture coordinates"),
      quadrics_(device, bytesOf(scene.quadrics), "quadrics"),
      materials_(device, bytesOf(scene.materials), "materials"),
      textures_(device, bytesOf(scene.textures), "textures"),
      texelRows_(device, bytesOf(scene.texelRows), "texels"),
      lights_(device, bytesOf(scene.lights), "lights"),
      filterQuantiles_(device, bytesOf(scene.filterQuantiles), "film filter") {}

std::vector<Binding> SceneBuffers::bindings() const {
    return {
        Binding::texelBuffer(shared::kBindingNodes, nodes_),
        Binding::texelBuffer(shared::kBindingTriangles, triangles_),
        Binding::texelBuffer(shared::kBindingTriangleNormals, triangleNormals_),
        Binding::texelBuffer(shared::kBindingTriangleUvs, triangleUvs_),
        Binding::texelBuffer(shared::kBindingQuadrics, quadrics_),
        Binding::texelBuffer(shared::kBindingMaterials, materials_),
        Binding::texelBuffer(shared::kBindingTextures, textures_),
        Binding::texelBuffer(shared::kBindingTexels, texelRows_),
        Binding::texelBuffer(shared::kBindingLights, lights_),
        Binding::texelBuffer(shared::kBindingFilter, filterQuantiles_),
    };
}

} // namespace calotype
