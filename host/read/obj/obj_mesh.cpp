#include "read/obj/obj_mesh.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "base/names.h"
#include "read/mesh_formats.h"
#include "scene/material_textures.h"

namespace calotype {
namespace {

void warnOfMissingUvs(std::span<const Mesh::Triangle> triangles, const ObjMeshInput& input,
                      ReadContext& context) {
    std::set<uint32_t> lacking;
    for (const Mesh::Triangle& triangle : triangles)
        if (triangle.uv[0] == Mesh::kNoUv)
            lacking.insert(triangle.material);
    for (const uint32_t index : lacking) {
        const Material& material = context.scene.materials[index];
        const bool isDisplaced = index < input.displacements.size() && input.displacements[index];
        if (hasTextures(material) || isDisplaced) {
            context.warn(input.path, "faces of the textured material " + inQuotes(material.name) +
                                         " lack texture coordinates, which count as (0, 0)");
        }
    }
}

} // namespace

std::shared_ptr<const ObjFile> readObj(const std::string& path, const std::string& where,
                                       ObjCache& cache, ReadContext& context) {
    std::shared_ptr<const ObjFile>& cached = cache.files[path];
    if (!cached) {
        context.progress(path, 0.0);
        const std::string text = context.read(path, where);
        cached = std::make_shared<ObjFile>(meshFormatOf(path).parse(text, path));
        context.progress(path, 0.7);
        if (cached->crossingPolygons > 0) {
            context.warn(path, "polygons that cross themselves or are far from flat, cut into "
                               "triangles that may overlap: " +
                                   std::to_string(cached->crossingPolygons));
        }
    }
    return cached;
}

Mesh buildObjMesh(const ObjFile& obj, const ObjMeshInput& input, ReadContext& context) {
    std::vector<Mesh::Triangle> triangles = obj.triangles;
    for (Mesh::Triangle& triangle : triangles) {
        triangle.material =
            input.materials[std::min<size_t>(triangle.material, input.materials.size() - 1)];
    }
    warnOfMissingUvs(triangles, input, context);
    ObjectMesh source{obj.positions, obj.normals, obj.uvs, triangles};
    const auto displaced =
        displace(source, input.displacements, context.scene.textures, input.path);
    if (displaced)
        source = {displaced->positions, displaced->normals, displaced->uvs, displaced->triangles};
    auto [mesh, dropped] = buildMesh(source, input.worldFromObject, input.normals, input.where);
    if (dropped > 0) {
        context.scene.droppedTriangles += dropped;
        context.warn(input.path,
                     "triangles left out because they have no area: " + std::to_string(dropped));
    }
    context.progress(input.path, 1.0);
    return std::move(mesh);
}

} // namespace calotype
