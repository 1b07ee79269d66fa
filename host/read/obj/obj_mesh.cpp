#include "read/obj/obj_mesh.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>

#include "base/find_file.h"
#include "base/names.h"
#include "read/mesh_formats.h"
#include "scene/material_textures.h"

namespace calotype {
namespace {

void warnOfMissingUvs(const std::set<uint32_t>& lacking, const ObjMeshInput& input,
                      ReadContext& context) {
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

ObjFile parseMesh(std::string_view text, const std::string& path, const OnProgress& onProgress) {
    refuseOtherKinds(text, path);
    return meshFormatOf(path).parse(text, path, onProgress);
}

BuiltObjMesh build(const ObjFile& obj, const ObjMeshInput& input, std::span<const Texture> textures,
                   const OnProgress& onProgress) {
    BuiltObjMesh built;
    std::vector<Mesh::Triangle> triangles = obj.triangles;
    for (Mesh::Triangle& triangle : triangles) {
        triangle.material =
            input.materials[std::min<size_t>(triangle.material, input.materials.size() - 1)];
        if (triangle.uv[0] == Mesh::kNoUv)
            built.lackingUvs.insert(triangle.material);
    }
    ObjectMesh source{obj.positions, obj.normals, obj.uvs, triangles};
    const auto normals =
        input.normals == NormalMode::Auto ? SurfaceNormals::Made : SurfaceNormals::LeftOut;
    const auto displaced = displace(source, input.displacements, textures, input.path, normals);
    if (displaced)
        source = {displaced->positions, displaced->normals, displaced->uvs, displaced->triangles};
    built.mesh = buildMesh(source, input.worldFromObject, input.normals, input.where, onProgress);
    return built;
}

/// About the bytes of the mesh.
uint64_t costOf(const ObjFile& obj, const ObjMeshInput& input) {
    uint32_t subdivide = 0;
    for (const auto& displacement : input.displacements)
        if (displacement)
            subdivide = std::max(subdivide, displacement->subdivide);
    return (obj.triangles.size() * sizeof(Mesh::Triangle)) << (2 * subdivide);
}

} // namespace

void startObj(const std::string& path, ObjCache& cache, ReadContext& context) {
    context.startAhead(path, cache.ahead,
                       [path](std::string_view text, const OnProgress& onProgress) {
                           return parseMesh(text, path, onProgress);
                       });
}

std::shared_ptr<const ObjFile> readObj(const std::string& path, const std::string& where,
                                       ObjCache& cache, ReadContext& context) {
    std::shared_ptr<const ObjFile>& cached = cache.files[truePath(path)];
    if (!cached) {
        const auto onProgress = [&](double done) { context.progress(path, 0.7 * done); };
        onProgress(0.0);
        cached = context.takeAhead(path, cache.ahead, onProgress);
        if (!cached)
            cached = std::make_shared<const ObjFile>(
                parseMesh(context.read(path, where), path, onProgress));
        for (const ObjNote& note : cached->notes)
            context.warn(path, note.message, note.kind);
    }
    return cached;
}

BegunObjMesh beginObjMesh(std::shared_ptr<const ObjFile> obj, ObjMeshInput given,
                          ReadContext& context) {
    const auto input = std::make_shared<const ObjMeshInput>(std::move(given));
    const uint64_t cost = costOf(*obj, *input);
    // A copy: the scene's own list may grow while the mesh is built.
    const auto textures =
        input->displacements.empty() ? std::vector<Texture>() : context.scene.textures;
    const auto work = [obj = std::move(obj), input, textures](const OnProgress& onProgress) {
        return build(*obj, *input, textures, onProgress);
    };
    return {input, context.tasks.add(cost, work)};
}

Mesh finishObjMesh(const BegunObjMesh& begun, ReadContext& context) {
    const ObjMeshInput& input = *begun.input;
    BuiltObjMesh built = context.tasks.finish(
        *begun.task, [&](double done) { context.progress(input.path, 0.7 + 0.3 * done); });
    warnOfMissingUvs(built.lackingUvs, input, context);
    const uint64_t dropped = built.mesh.dropped;
    if (dropped > 0) {
        context.scene.droppedTriangles += dropped;
        const std::string kind = "triangles left out because they have no area";
        context.warn(input.path, kind + ": " + std::to_string(dropped), kind);
    }
    context.progress(input.path, 1.0);
    return std::move(built.mesh.mesh);
}

} // namespace calotype
