#include "scene/read_mesh.h"

#include <array>

#include "scene/mesh_builder.h"
#include "scene/mesh_materials.h"
#include "scene/names.h"
#include "scene/read_file.h"
#include "scene/read_transform.h"

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

} // namespace

Mesh readMesh(const JsonObject& object, LoadContext& context) {
    object.refuse("displacement");
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
    auto [mesh, dropped] =
        buildMesh(obj->positions, obj->normals, triangles, worldFromObject, mode, file.where());
    if (dropped > 0) {
        context.scene.droppedTriangles += dropped;
        context.warn(path,
                     "triangles left out because they have no area: " + std::to_string(dropped));
    }
    context.progress(path, 1.0);
    return std::move(mesh);
}

} // namespace calotype
