#include "read/json/mesh.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>

#include "base/names.h"
#include "base/read_file.h"
#include "mesh/displacement.h"
#include "mesh/mesh_builder.h"
#include "read/json/displacement.h"
#include "read/json/mesh_materials.h"
#include "read/json/transform.h"
#include "scene/material_textures.h"

namespace calotype {
namespace {

const std::array<std::string, 3> kNormalModes = {"auto", "smooth", "flat"};

std::shared_ptr<const ObjFile> readObj(const JsonValue& file, const std::string& path,
                                       LoadContext& context) {
    std::shared_ptr<const ObjFile>& cached = context.objFiles[path];
    if (!cached) {
        context.progress(path, 0.0);
        const std::string text = readFile(path, file.where());
        context.hash.add(text);
        cached = std::make_shared<ObjFile>(parseObj(text, path));
        context.progress(path, 0.7);
        if (cached->crossingPolygons > 0) {
            context.warn(path, "polygons that cross themselves or are far from flat, cut into "
                               "triangles that may overlap: " +
                                   std::to_string(cached->crossingPolygons));
        }
    }
    return cached;
}

/// By material: the mesh's own for all, or else the materials' own.
std::vector<std::optional<Displacement>> readDisplacements(const JsonObject& mesh,
                                                           const LoadContext& context) {
    if (const auto own = mesh.optional("displacement")) {
        return {context.scene.materials.size(), readDisplacement(*own, context)};
    }
    return context.displacements;
}

void warnOfMissingUvs(std::span<const Mesh::Triangle> triangles,
                      std::span<const std::optional<Displacement>> displacements,
                      const std::string& path, LoadContext& context) {
    std::set<uint32_t> lacking;
    for (const Mesh::Triangle& triangle : triangles) {
        if (triangle.uv[0] == Mesh::kNoUv) {
            lacking.insert(triangle.material);
        }
    }
    for (const uint32_t index : lacking) {
        const Material& material = context.scene.materials[index];
        if (hasTextures(material) || (index < displacements.size() && displacements[index])) {
            context.warn(path, "faces that bear the textured material " + inQuotes(material.name) +
                                   " lack texture coordinates, which count as (0, 0)");
        }
    }
}

} // namespace

Mesh readMesh(const JsonObject& object, LoadContext& context) {
    const AffineTransform worldFromObject = readTransform(object);
    auto mode = NormalMode::Auto;
    if (const auto normals = object.optional("normals")) {
        mode = static_cast<NormalMode>(normals->choice(kNormalModes));
    }
    const JsonValue file = object.required("file");
    const std::string path = (context.directory / file.text()).string();
    const std::shared_ptr<const ObjFile> obj = readObj(file, path, context);

    const std::vector<uint32_t> materials = resolveMeshMaterials(object, *obj, path, context);
    std::vector<Mesh::Triangle> triangles = obj->triangles;
    for (Mesh::Triangle& triangle : triangles) {
        triangle.material = materials[std::min<size_t>(triangle.material, materials.size() - 1)];
    }
    const auto displacements = readDisplacements(object, context);
    warnOfMissingUvs(triangles, displacements, path, context);
    ObjectMesh source{obj->positions, obj->normals, obj->uvs, triangles};
    const auto displaced = displace(source, displacements, context.scene.textures, path);
    if (displaced) {
        source = {displaced->positions, displaced->normals, displaced->uvs, displaced->triangles};
    }
    auto [mesh, dropped] = buildMesh(source, worldFromObject, mode, file.where());
    if (dropped > 0) {
        context.scene.droppedTriangles += dropped;
        context.warn(path,
                     "triangles left out because they have no area: " + std::to_string(dropped));
    }
    context.progress(path, 1.0);
    return std::move(mesh);
}

} // namespace calotype
