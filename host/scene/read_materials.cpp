#include "scene/read_materials.h"

#include <algorithm>
#include <array>

#include "scene/names.h"
#include "scene/read_color.h"

namespace calotype {
namespace {

const std::array<std::string, 5> kTypes = {"diffuse", "metal", "nonmetal", "blinn_phong",
                                           "dielectric"};
const std::array<std::string, 2> kSides = {"both", "front"};

Material readMaterial(const JsonValue& value, const std::string& name) {
    const size_t type = choiceAt(value, "type", kTypes);
    if (type != 0) {
        failUnsupported(value.child("type"), "the material type " + inQuotes(kTypes[type]));
    }
    const JsonObject object(value, {"type", "color", "emission", "emission_side", "normal_map",
                                    "alpha", "displacement"});
    for (const char* key : {"normal_map", "displacement"}) {
        object.refuse(key);
    }
    if (const auto alpha = object.optional("alpha"); alpha && !alpha->boolean()) {
        failUnsupported(*alpha, "ignoring a texture's alpha");
    }
    Material material;
    material.name = name;
    material.color = readReflectance(object.required("color"));
    if (const auto emission = object.optional("emission")) {
        material.emission = readRadiance(*emission);
    }
    if (const auto side = object.optional("emission_side")) {
        material.emitsFromFrontOnly = side->choice(kSides) == 1;
    }
    return material;
}

} // namespace

void readMaterials(const JsonValue& value, LoadContext& context) {
    if (!value.json().is_object()) {
        value.fail("must be an object of materials by name");
    }
    for (const auto& [name, unused] : value.json().items()) {
        context.addMaterial(readMaterial(value.child(name), name));
        context.materialNames.push_back(name);
    }
}

uint32_t findMaterial(const JsonValue& reference, const LoadContext& context) {
    const auto& names = context.materialNames;
    const auto found = std::lower_bound(names.begin(), names.end(), reference.text());
    if (found == names.end() || *found != reference.text()) {
        reference.fail("there is no material " + inQuotes(reference.text()) +
                       suggestion(reference.text(), names));
    }
    return static_cast<uint32_t>(found - names.begin());
}

} // namespace calotype
