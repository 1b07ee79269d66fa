#include "read/json/type.h"

#include <cmath>
#include <cstdint>
#include <utility>

#include <nlohmann/json.hpp>

#include "base/names.h"
#include "read/json/color.h"

namespace calotype {
namespace {

/// Whole numbers without ".0".
SchemaJson numberJson(double number) {
    const auto whole = static_cast<int64_t>(number);
    return static_cast<double>(whole) == number ? SchemaJson(whole) : SchemaJson(number);
}

SchemaJson numberSchema(const Range& range) {
    SchemaJson schema = {{"type", "number"}};
    if (std::isfinite(range.low))
        schema[range.isLowOpen ? "exclusiveMinimum" : "minimum"] = numberJson(range.low);
    if (std::isfinite(range.high))
        schema[range.isHighOpen ? "exclusiveMaximum" : "maximum"] = numberJson(range.high);
    return schema;
}

SchemaJson arraySchema(const SchemaJson& items, size_t count) {
    return {{"type", "array"}, {"items", items}, {"minItems", count}, {"maxItems", count}};
}

SchemaJson described(SchemaJson schema, const std::string& description) {
    schema["description"] = description;
    return schema;
}

/// A type that does not depend on other definitions.
JsonType fixedType(std::function<void(const JsonValue&)> check, SchemaJson schema) {
    return {std::move(check), [schema = std::move(schema)](SchemaJson&) { return schema; }};
}

JsonType colorType(const std::string& name, const Range& channel, const std::string& description) {
    const auto schema = [=](SchemaJson& definitions) {
        const SchemaJson hex =
            namedType("hexColor",
                      fixedType({}, {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}}))
                .schema(definitions);
        const SchemaJson number = numberSchema(channel);
        return described({{"anyOf", {number, arraySchema(number, 3), hex}}}, description);
    };
    return namedType(name, {[=](const JsonValue& value) { readColor(value, channel); }, schema});
}

/// `type` or the name of a texture.
JsonType orTextureType(const JsonType& type, const std::string& description,
                       std::function<void(const JsonValue&)> check) {
    const auto schema = [=](SchemaJson& definitions) {
        const SchemaJson alternatives = {type.schema(definitions),
                                         textureNameType().schema(definitions)};
        return described({{"anyOf", alternatives}}, description);
    };
    return {std::move(check), schema};
}

} // namespace

JsonType numberType(const Range& range) {
    return fixedType([=](const JsonValue& value) { value.numberIn(range); }, numberSchema(range));
}

JsonType nonZeroNumberType() {
    const auto check = [](const JsonValue& value) {
        if (value.number() == 0.0)
            value.fail("must not be 0");
    };
    return fixedType(check, {{"type", "number"}, {"not", {{"const", 0}}}});
}

JsonType wholeNumberType(const ranges::WholeRange& range) {
    return fixedType([=](const JsonValue& value) { value.wholeNumber(range); },
                     {{"type", "integer"}, {"minimum", range.low}, {"maximum", range.high}});
}

JsonType booleanType() {
    return fixedType([](const JsonValue& value) { value.boolean(); }, {{"type", "boolean"}});
}

JsonType textType() {
    return fixedType([](const JsonValue& value) { value.text(); }, {{"type", "string"}});
}

JsonType constantType(const std::string& text, const std::string& description) {
    return fixedType({}, described({{"const", text}}, description));
}

JsonType choiceType(std::span<const std::string> names) {
    return fixedType([=](const JsonValue& value) { value.choice(names); },
                     {{"enum", std::vector<std::string>(names.begin(), names.end())}});
}

JsonType vectorType() {
    return namedType("vector", fixedType([](const JsonValue& value) { value.vector(); },
                                         arraySchema({{"type", "number"}}, 3)));
}

JsonType directionType() {
    SchemaJson schema = arraySchema({{"type", "number"}}, 3);
    schema["not"] = {{"items", {{"const", 0}}}};
    return namedType("direction",
                     fixedType([](const JsonValue& value) { value.direction(); }, schema));
}

JsonType matrixType() {
    constexpr size_t kCount = 16;
    SchemaJson items = SchemaJson::array();
    for (size_t i = 0; i < kCount; ++i) {
        items.push_back(i < 12 ? SchemaJson{{"type", "number"}}
                               : SchemaJson{{"const", i + 1 == kCount ? 1 : 0}});
    }
    const auto check = [](const JsonValue& value) {
        for (const JsonValue& entry : value.array(kCount))
            entry.number();
    };
    return namedType("matrix", fixedType(check, described(arraySchema(items, kCount),
                                                          "16 numbers, row-major; the last row is "
                                                          "0 0 0 1.")));
}

JsonType scaleType() {
    const auto check = [](const JsonValue& value) {
        value.json().is_number() ? void(value.number()) : void(value.vector());
    };
    const SchemaJson factor = {{"type", "number"}, {"not", {{"const", 0}}}};
    return namedType("scale", fixedType(check, {{"anyOf", {factor, arraySchema(factor, 3)}}}));
}

JsonType arrayType(const JsonType& element, size_t count) {
    const auto check = [=](const JsonValue& value) {
        for (const JsonValue& item : value.array(count))
            if (element.check)
                element.check(item);
    };
    return {check, [=](SchemaJson& definitions) {
                return arraySchema(element.schema(definitions), count);
            }};
}

JsonType arrayType(const JsonType& element) {
    return {[](const JsonValue& value) { value.array(); },
            [=](SchemaJson& definitions) {
                return SchemaJson{{"type", "array"}, {"items", element.schema(definitions)}};
            }};
}

JsonType mapType(const JsonType& value) {
    return {{}, [=](SchemaJson& definitions) {
                return SchemaJson{{"type", "object"},
                                  {"additionalProperties", value.schema(definitions)}};
            }};
}

JsonType reflectanceType() {
    return colorType("reflectance", ranges::kShare,
                     "A colour in [0, 1]: [r, g, b] (linear Rec. 709), one number for grey, or "
                     "\"#rrggbb\" (sRGB).");
}

JsonType radianceType() {
    return colorType("radiance", ranges::kRadiance,
                     "[r, g, b] (linear Rec. 709), one number for grey, or \"#rrggbb\" (sRGB); 0 "
                     "or greater.");
}

JsonType textureNameType() {
    const auto check = [](const JsonValue& value) {
        if (!canBeTextureName(value.text()))
            value.fail("must be the name of a texture, not " + inQuotes(value.text()));
    };
    return namedType("textureName",
                     fixedType(check, described({{"type", "string"}, {"pattern", "^[^#]"}},
                                                "A name in \"textures\".")));
}

JsonType materialNameType() {
    return namedType("materialName",
                     fixedType([](const JsonValue& value) { value.text(); },
                               described({{"type", "string"}}, "A name in \"materials\".")));
}

JsonType reflectanceOrTextureType() {
    const auto check = [](const JsonValue& value) {
        if (!value.json().is_string() || !canBeTextureName(value.text()))
            readColor(value, ranges::kShare);
    };
    return namedType("reflectanceOrTexture",
                     orTextureType(reflectanceType(),
                                   "A colour in [0, 1]: [r, g, b] (linear Rec. 709), one number "
                                   "for grey, \"#rrggbb\" (sRGB), or the name of a texture.",
                                   check));
}

JsonType numberOrTextureType(const Range& range) {
    const auto check = [=](const JsonValue& value) {
        if (value.json().is_string())
            textureNameType().check(value);
        else if (value.json().is_number())
            value.numberIn(range);
        else
            value.fail("must be a number " + toText(range) + " or the name of a texture");
    };
    return orTextureType(numberType(range), "A number, or a texture whose first channel is read.",
                         check);
}

JsonType namedType(const std::string& name, const JsonType& type) {
    const auto schema = [=](SchemaJson& definitions) {
        if (!definitions.contains(name)) {
            definitions[name] = nullptr; // keeps its place while its parts are added
            SchemaJson defined = type.schema(definitions);
            definitions[name] = std::move(defined);
        }
        return SchemaJson{{"$ref", "#/definitions/" + name}};
    };
    return {type.check, schema};
}

} // namespace calotype
