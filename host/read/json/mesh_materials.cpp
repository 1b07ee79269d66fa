#include "read/json/mesh_materials.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string_view>

#include <nlohmann/json.hpp>

#include "base/names.h"
#include "read/json/materials.h"
#include "read/obj/obj_materials.h"
#include "read/obj/readings.h"

namespace calotype {
namespace {

constexpr const char* kEveryOther = "*";

std::string listOf(const ObjFile& obj) {
    return obj.materialNames.empty() ? "its faces have no materials"
                                     : "its faces have " + listInQuotes(obj.materialNames);
}

/// For each of the OBJ's materials the key of `map` that names it (see readingsOf), if there is
/// one.
std::vector<std::optional<std::string>> keysOf(const JsonValue& map, const ObjFile& obj,
                                               const std::string& objPath) {
    std::set<std::string_view> known;
    std::vector<std::optional<std::string>> keys;
    for (const std::string& name : obj.materialNames) {
        auto& key = keys.emplace_back();
        for (const std::string_view reading : readingsOf(name)) {
            known.insert(reading);
            if (!key && map.json().contains(reading))
                key = reading;
        }
    }
    for (const auto& [key, unused] : map.json().items()) {
        if (key != kEveryOther && !known.contains(key)) {
            map.child(key).fail("no face of " + inQuotes(objPath) + " has the material " +
                                inQuotes(key) + "; " + listOf(obj));
        }
    }
    return keys;
}

std::vector<uint32_t> resolveByName(const JsonValue& map, const ObjFile& obj,
                                    const std::string& objPath, JsonContext& context) {
    if (!map.json().is_object())
        map.fail("must be an object from the OBJ's material names to materials of the scene");
    std::vector<std::optional<std::string>> keys = keysOf(map, obj, objPath);
    keys.emplace_back(); // of faces without a material
    NeededMaterials needed = allMaterials(obj);
    std::vector<uint32_t> given(keys.size());
    for (size_t i = 0; i < keys.size(); ++i) {
        const std::string key = keys[i].value_or(kEveryOther);
        if (map.json().contains(key)) {
            given[i] = findMaterial(map.child(key), context);
            needed[i] = false;
        }
    }
    if (std::ranges::find(needed, true) == needed.end())
        return given;
    const auto others = materialsFromMtl(obj, objPath, needed, context.objs, context);
    for (size_t i = 0; i < keys.size(); ++i)
        if (needed[i])
            given[i] = others[i];
    return given;
}

} // namespace

std::vector<uint32_t> resolveMeshMaterials(const JsonObject& mesh, const ObjFile& obj,
                                           const std::string& objPath, JsonContext& context) {
    if (const auto material = mesh.optional("material"))
        return {findMaterial(*material, context)};
    if (const auto materials = mesh.optional("materials"))
        return resolveByName(*materials, obj, objPath, context);
    return materialsFromMtl(obj, objPath, allMaterials(obj), context.objs, context);
}

} // namespace calotype
