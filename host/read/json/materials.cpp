#include "read/json/materials.h"

#include <algorithm>
#include <array>
#include <optional>

#include "base/names.h"
#include "read/json/color.h"
#include "read/json/displacement.h"
#include "read/json/texture_slots.h"

namespace calotype {
namespace {

/// Far beyond any real material's; the square of a ratio stays well within float.
constexpr double kLowestIor = 0.01;
constexpr double kHighestIor = 100.0;

/// In the order of MaterialType.
const std::array<std::string, 5> kTypes = {"diffuse", "metal", "nonmetal", "blinn_phong",
                                           "dielectric"};
/// In the order of Masking.
const std::array<std::string, 2> kMaskings = {"schlick", "smith"};
const std::array<std::string, 2> kSides = {"both", "front"};

std::vector<std::string> keysOf(MaterialType type) {
    std::vector<std::string> keys = {"type", "color"};
    switch (type) {
    case MaterialType::Diffuse:
        break;
    case MaterialType::Metal:
        keys.insert(keys.end(), {"roughness", "masking"});
        break;
    case MaterialType::Nonmetal:
        keys.insert(keys.end(), {"roughness", "specular", "masking"});
        break;
    case MaterialType::BlinnPhong:
        keys.insert(keys.end(), {"kd", "ks", "exponent", "normalize"});
        break;
    case MaterialType::Dielectric:
        keys.insert(keys.end(), {"ior", "exterior_ior"});
        break;
    }
    keys.insert(keys.end(), {"normal_map", "displacement"});
    if (type != MaterialType::Dielectric) {
        keys.insert(keys.end(), {"emission", "emission_side", "alpha"});
    }
    return keys;
}

void readColorAndAlpha(const JsonObject& object, Material& material, const LoadContext& context) {
    const ColorSlot slot = readColorSlot(object.required("color"), context);
    material.color = slot.color;
    material.colorTexture = slot.texture;
    if (!object.boolean("alpha", true) || slot.texture == Material::kNoTexture) {
        return;
    }
    const auto* image = std::get_if<ImageTexture>(&context.scene.textures[slot.texture].source);
    if (image && image->image->isTransparent) {
        material.alphaTexture = slot.texture;
    }
}

/// The keys that all materials but the dielectric have.
void readOpaque(const JsonObject& object, Material& material, const LoadContext& context) {
    readColorAndAlpha(object, material, context);
    if (const auto emission = object.optional("emission")) {
        material.emission = readRadiance(*emission);
    }
    if (const auto side = object.optional("emission_side")) {
        material.emitsFromFrontOnly = side->choice(kSides) == 1;
    }
}

void readMicrofacets(const JsonObject& object, Material& material, const LoadContext& context) {
    const ScalarSlot roughness = readScalarSlot(object.required("roughness"), context);
    material.roughness = roughness.number;
    material.roughnessTexture = roughness.texture;
    if (const auto masking = object.optional("masking")) {
        material.masking = static_cast<Masking>(masking->choice(kMaskings));
    }
}

void readSpecular(const JsonObject& object, Material& material, const LoadContext& context) {
    if (const auto value = object.optional("specular")) {
        const ScalarSlot specular = readScalarSlot(*value, context);
        material.specular = specular.number;
        material.specularTexture = specular.texture;
    }
}

void readBlinnPhong(const JsonObject& object, Material& material) {
    material.kd = object.required("kd").numberIn(0.0, 1.0);
    material.ks = object.required("ks").numberIn(0.0, 1.0);
    material.exponent = object.required("exponent").numberIn(0.0, Material::kHighestExponent);
    material.normalize = object.boolean("normalize", false);
}

void readDielectric(const JsonObject& object, Material& material) {
    const auto color = object.optional("color");
    material.color = color ? readReflectance(*color) : glm::dvec3(1.0);
    material.ior = object.required("ior").numberIn(kLowestIor, kHighestIor);
    if (const auto exterior = object.optional("exterior_ior")) {
        material.exteriorIor = exterior->numberIn(kLowestIor, kHighestIor);
    }
}

/// A mistake that deserves more than "unknown key".
void refuseEmission(const JsonValue& dielectric) {
    for (const char* key : {"emission", "emission_side"}) {
        if (dielectric.json().contains(key)) {
            dielectric.child(key).fail("a dielectric cannot emit light; give the emission to an "
                                       "opaque material, of a shape inside it perhaps");
        }
    }
}

Material readMaterial(const JsonValue& value, const std::string& name, const LoadContext& context) {
    Material material;
    material.name = name;
    material.type = static_cast<MaterialType>(choiceAt(value, "type", kTypes));
    if (material.type == MaterialType::Dielectric) {
        refuseEmission(value);
    }
    const JsonObject object(value, keysOf(material.type));
    if (material.type == MaterialType::Dielectric) {
        readDielectric(object, material);
    } else {
        readOpaque(object, material, context);
    }
    if (const auto map = object.optional("normal_map")) {
        material.normalMap = readImageName(*map, context);
    }
    if (material.type == MaterialType::Metal || material.type == MaterialType::Nonmetal) {
        readMicrofacets(object, material, context);
    }
    if (material.type == MaterialType::Nonmetal) {
        readSpecular(object, material, context);
    }
    if (material.type == MaterialType::BlinnPhong) {
        readBlinnPhong(object, material);
    }
    return material;
}

} // namespace

void readMaterials(const JsonValue& value, LoadContext& context) {
    if (!value.json().is_object()) {
        value.fail("must be an object of materials by name");
    }
    for (const auto& [name, material] : value.json().items()) {
        const JsonValue place = value.child(name);
        Material& added = context.scene.materials.emplace_back(readMaterial(place, name, context));
        added.place = place.where();
        context.materialNames.push_back(name);
        std::optional<Displacement>& displacement = context.displacements.emplace_back();
        if (material.contains("displacement")) {
            displacement = readDisplacement(place.child("displacement"), context);
        }
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
