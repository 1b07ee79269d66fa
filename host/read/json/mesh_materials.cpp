#include "read/json/mesh_materials.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/names.h"
#include "read/json/materials.h"
#include "read/obj/mtl_library.h"

namespace calotype {
namespace {

constexpr const char* kEveryOther = "*";

std::string listOf(const ObjFile& obj) {
    return obj.materialNames.empty() ? "its faces have no materials"
                                     : "its faces have " + listInQuotes(obj.materialNames);
}

std::vector<uint32_t> resolveByName(const JsonValue& map, const ObjFile& obj,
                                    const std::string& objPath, const JsonContext& context) {
    if (!map.json().is_object())
        map.fail("must be an object from the OBJ's material names to materials of the scene");
    const auto& names = obj.materialNames;
    for (const auto& [key, unused] : map.json().items()) {
        if (key != kEveryOther && std::find(names.begin(), names.end(), key) == names.end()) {
            map.child(key).fail("no face of " + inQuotes(objPath) + " has the material " +
                                inQuotes(key) + "; " + listOf(obj));
        }
    }
    std::optional<uint32_t> everyOther;
    if (map.json().contains(kEveryOther))
        everyOther = findMaterial(map.child(kEveryOther), context);
    std::vector<uint32_t> result;
    for (const std::string& name : names) {
        if (map.json().contains(name)) {
            result.push_back(findMaterial(map.child(name), context));
        } else if (everyOther) {
            result.push_back(*everyOther);
        } else {
            map.fail("does not say what " + inQuotes(name) +
                     " becomes (\"*\" stands for every "
                     "other); " +
                     listOf(obj));
        }
    }
    if (obj.hasFacesWithoutMaterial && !everyOther) {
        map.fail("some faces of " + inQuotes(objPath) +
                 " have no material; add \"*\", which stands for these too");
    }
    result.push_back(everyOther.value_or(0));
    return result;
}

} // namespace

std::vector<uint32_t> resolveMeshMaterials(const JsonObject& mesh, const ObjFile& obj,
                                           const std::string& objPath, JsonContext& context) {
    if (const auto material = mesh.optional("material"))
        return {findMaterial(*material, context)};
    if (const auto materials = mesh.optional("materials"))
        return resolveByName(*materials, obj, objPath, context);
    return materialsFromMtl(obj, objPath, UndefinedMaterials::Fail, context.objs, context);
}

} // namespace calotype
