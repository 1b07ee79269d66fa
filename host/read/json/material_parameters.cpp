#include "read/json/material_parameters.h"

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include <nlohmann/json.hpp>

#include "read/json/color.h"
#include "read/json/textures.h"

namespace calotype {
namespace {

struct KeyWriter {
    const MaterialParameter& parameter;

    JsonKey operator()(const NumberParameter& number) const {
        return with(number.texture ? numberOrTextureType(number.range) : numberType(number.range));
    }
    JsonKey operator()(const ColorParameter& color) const {
        return with(color.texture              ? reflectanceOrTextureType()
                    : color.channel.high > 1.0 ? radianceType()
                                               : reflectanceType());
    }
    JsonKey operator()(const FlagParameter&) const {
        JsonKey key(parameter.name, booleanType(), parameter.description);
        return std::move(key).orElse(*parameter.otherwise != 0.0);
    }
    JsonKey operator()(const ChoiceParameter& choice) const {
        JsonKey key(parameter.name, choiceType(choice.names), parameter.description);
        const auto index = static_cast<size_t>(*parameter.otherwise);
        return std::move(key).orElseJson("\"" + choice.names[index] + "\"");
    }

private:
    JsonKey with(const JsonType& type) const {
        JsonKey key(parameter.name, type, parameter.description);
        key.unit = parameter.unit;
        return parameter.otherwise ? std::move(key).orElse(*parameter.otherwise)
                                   : std::move(key).required();
    }
};

struct ParameterReader {
    const MaterialParameter& parameter;
    const std::optional<JsonValue> value;
    const JsonContext& context;
    Material& material;

    void operator()(const NumberParameter& number) const {
        if (number.texture && namesTexture()) {
            material.*number.texture = findTexture(*value, context);
            material.*number.number = 1.0;
            if (context.scene.textures[material.*number.texture].isMissing) {
                material.*number.texture = Material::kNoTexture;
                material.*number.number = parameter.otherwise.value_or(1.0);
            }
        } else {
            material.*number.number = value ? value->number() : *parameter.otherwise;
        }
    }
    void operator()(const ColorParameter& color) const {
        if (color.texture && namesTexture()) {
            material.*color.texture = findTexture(*value, context);
            material.*color.color = glm::dvec3(1.0);
        } else {
            material.*color.color =
                value ? readColor(*value, color.channel) : glm::dvec3(*parameter.otherwise);
        }
    }
    void operator()(const FlagParameter& flag) const {
        material.*flag.flag = value ? value->boolean() : *parameter.otherwise != 0.0;
    }
    void operator()(const ChoiceParameter& choice) const {
        choice.set(material,
                   value ? value->choice(choice.names) : static_cast<size_t>(*parameter.otherwise));
    }

private:
    bool namesTexture() const {
        return value && value->json().is_string() && canBeTextureName(value->text());
    }
};

} // namespace

JsonKey keyOf(const MaterialParameter& parameter) {
    return std::visit(KeyWriter{parameter}, parameter.value);
}

void readParameter(const MaterialParameter& parameter, const JsonObject& object,
                   const JsonContext& context, Material& material) {
    std::visit(ParameterReader{parameter, object.optional(parameter.name), context, material},
               parameter.value);
}

} // namespace calotype
