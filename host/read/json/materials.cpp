#include "read/json/materials.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/names.h"
#include "materials/material_kind.h"
#include "materials/parameters.h"
#include "read/json/displacement.h"
#include "read/json/material_parameters.h"
#include "read/json/textures.h"

namespace calotype {
namespace {

/// The parameters of one kind of material, including those of all opaque materials.
std::vector<MaterialParameter> parametersOf(const MaterialKind& kind) {
    std::vector<MaterialParameter> parameters = kind.parameters;
    if (kind.isOpaque) {
        parameters.push_back(emissionParameter());
        parameters.push_back(emissionSideParameter());
    }
    return parameters;
}

JsonObjectType objectTypeOf(const MaterialKind& kind) {
    std::vector<JsonKey> keys;
    for (const MaterialParameter& parameter : parametersOf(kind))
        keys.push_back(keyOf(parameter));
    keys.emplace_back("normal_map", textureNameType(),
                      "An image: a tangent-space normal map, +Y up as in OpenGL.");
    if (kind.isOpaque) {
        keys.push_back(
            JsonKey("alpha", booleanType(), "Whether the alpha of the colour's texture cuts holes.")
                .orElse(true));
    } else {
        for (const char* key : {"emission", "emission_side"}) {
            keys.push_back(refusedKey(key, "a " + kind.name +
                                               " cannot emit light; give the emission to an "
                                               "opaque material, of a shape inside it perhaps"));
        }
    }
    keys.push_back(displacementKey());
    return chosenType(kind.name, kind.description, std::move(keys));
}

/// In the order of materialKinds().
const JsonObjectTypes& materialTypes() {
    static const JsonObjectTypes types = [] {
        JsonObjectTypes made;
        for (const MaterialKind& kind : materialKinds())
            made.push_back(objectTypeOf(kind));
        return made;
    }();
    return types;
}

/// The texture of the colour, if it is an image with transparent texels.
uint32_t alphaTextureOf(const Material& material, const Scene& scene) {
    if (material.colorTexture == Material::kNoTexture)
        return Material::kNoTexture;
    const auto* image = std::get_if<ImageTexture>(&scene.textures[material.colorTexture].source);
    return image && image->image->isTransparent ? material.colorTexture : Material::kNoTexture;
}

Material readMaterial(const JsonValue& value, const std::string& name, JsonContext& context) {
    const size_t index = readType(value, materialTypes());
    const MaterialKind& kind = materialKinds()[index];
    const JsonObject object(value, materialTypes()[index]);
    Material material;
    material.name = name;
    material.place = value.where();
    material.type = static_cast<MaterialType>(index);
    for (const MaterialParameter& parameter : parametersOf(kind))
        readParameter(parameter, object, context, material);
    if (const auto map = object.optional("normal_map"))
        material.normalMap = findImage(*map, context);
    if (kind.isOpaque && object.boolean("alpha", true))
        material.alphaTexture = alphaTextureOf(material, context.scene);
    std::optional<Displacement>& displacement = context.displacements.emplace_back();
    if (const auto own = object.optional("displacement"))
        displacement = readDisplacement(*own, context);
    return material;
}

} // namespace

JsonType materialsType() { return objectMapType(anyOf(materialTypes(), "material")); }

void readMaterials(const JsonValue& value, JsonContext& context) {
    if (!value.json().is_object())
        value.fail("must be an object of materials by name");
    for (const std::string& name : namesInMap(value)) {
        context.addMaterial(readMaterial(value.child(name), name, context));
        context.materialNames.push_back(name);
    }
}

uint32_t findMaterial(const JsonValue& reference, const JsonContext& context) {
    const auto& names = context.materialNames;
    const auto found = std::lower_bound(names.begin(), names.end(), reference.text());
    if (found == names.end() || *found != reference.text()) {
        reference.fail("there is no material " + inQuotes(reference.text()) +
                       suggestion(reference.text(), names));
    }
    return static_cast<uint32_t>(found - names.begin());
}

} // namespace calotype
