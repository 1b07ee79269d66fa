#include "read/json/mesh.h"

#include <algorithm>
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "read/json/displacement.h"
#include "read/json/mesh_materials.h"
#include "read/json/transform.h"
#include "read/obj/obj_mesh.h"

namespace calotype {
namespace {

/// In the order of NormalMode.
const std::array<std::string, 3> kNormalModes = {"auto", "smooth", "flat"};

/// By material: that of the mesh for all materials, or else that of each material; empty if none of
/// `used` has one.
std::vector<std::optional<Displacement>> readDisplacements(const JsonObject& mesh,
                                                           const std::vector<uint32_t>& used,
                                                           const JsonContext& context) {
    if (const auto own = mesh.optional("displacement"))
        return {context.scene.materials.size(), readDisplacement(*own, context)};
    const auto& displacements = context.displacements;
    const bool anyMoves = std::ranges::any_of(used, [&](uint32_t material) {
        return material < displacements.size() && displacements[material];
    });
    return anyMoves ? displacements : std::vector<std::optional<Displacement>>();
}

} // namespace

std::vector<JsonKey> meshKeys() {
    return {
        JsonKey("file", textType(), "A Wavefront OBJ beside the scene file.").required(),
        JsonKey("material", materialNameType(),
                "The material of the whole mesh. With neither this nor materials, the OBJ's MTL "
                "files are read."),
        JsonKey(
            "materials", mapType(materialNameType()),
            "Materials of the scene by the OBJ's own names; \"*\" stands for every other. Without "
            "it, the others are those of the MTL files."),
        JsonKey(
            "normals", choiceType(kNormalModes),
            "auto: the file's where it has them, else those of its smoothing groups, else flat. "
            "smooth: the area-weighted mean at each position.")
            .orElseJson("\"auto\""),
        displacementKey(),
        transformKey(),
    };
}

JsonRule meshMaterialRule() { return exclude("material", "materials"); }

void startMeshFiles(const JsonValue& shapes, JsonContext& context) {
    if (!shapes.json().is_array())
        return;
    for (const nlohmann::json& shape : shapes.json())
        if (shape.is_object() && shape.contains("file") && shape["file"].is_string())
            startObj((context.directory / shape["file"].get<std::string>()).string(), context.objs,
                     context);
}

BegunObjMesh readMesh(const JsonObject& object, JsonContext& context) {
    const JsonValue file = object.required("file");
    const std::string path = (context.directory / file.text()).string();
    ObjMeshInput input{.path = path,
                       .where = file.where(),
                       .materials = {},
                       .displacements = {},
                       .worldFromObject = readTransform(object)};
    input.normals = static_cast<NormalMode>(object.choice("normals", kNormalModes, 0));
    const std::shared_ptr<const ObjFile> obj = readObj(path, file.where(), context.objs, context);
    input.materials = resolveMeshMaterials(object, *obj, path, context);
    input.displacements = readDisplacements(object, input.materials, context);
    return beginObjMesh(obj, std::move(input), context);
}

} // namespace calotype
