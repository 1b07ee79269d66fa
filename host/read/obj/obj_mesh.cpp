#include "read/obj/obj_mesh.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

#include "base/find_file.h"
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
    std::vector<std::string> names;
    for (const uint32_t index : lacking) {
        const Material& material = context.scene.materials[index];
        const bool isDisplaced = index < input.displacements.size() && input.displacements[index];
        if (hasTextures(material) || isDisplaced)
            names.push_back(material.name);
    }
    if (names.empty())
        return;
    context.warn(input.path,
                 std::string("faces of the textured material") + (names.size() > 1 ? "s " : " ") +
                     listInQuotes(names) + " lack texture coordinates, which count as (0, 0)",
                 "textured faces without texture coordinates");
}

} // namespace

std::shared_ptr<const ObjFile> readObj(const std::string& path, const std::string& where,
                                       ObjCache& cache, ReadContext& context) {
    std::shared_ptr<const ObjFile>& cached = cache.files[truePath(path)];
    if (!cached) {
        context.progress(path, 0.0);
        const std::string text = context.read(path, where);
        refuseOtherKinds(text, path);
        const auto onProgress = [&](double done) { context.progress(path, 0.7 * done); };
        cached = std::make_shared<ObjFile>(meshFormatOf(path).parse(text, path, onProgress));
        for (const ObjNote& note : cached->notes)
            context.warn(path, note.message, note.kind);
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
    const auto onProgress = [&](double done) { context.progress(input.path, 0.7 + 0.3 * done); };
    auto [mesh, dropped] =
        buildMesh(source, input.worldFromObject, input.normals, input.where, onProgress);
    if (dropped > 0) {
        context.scene.droppedTriangles += dropped;
        const std::string kind = "triangles left out because they have no area";
        context.warn(input.path, kind + ": " + std::to_string(dropped), kind);
    }
    context.progress(input.path, 1.0);
    return std::move(mesh);
}

} // namespace calotype
