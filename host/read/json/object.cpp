#include "read/json/object.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/check.h"
#include "base/names.h"
#include "base/number_text.h"

namespace calotype {
namespace {

/// The key that every object may have.
const JsonKey& descriptionKey() {
    static const JsonKey key("description", textType(), "Any text; it has no effect.");
    return key;
}

/// The names of the keys that the schema has.
std::vector<std::string> namesOf(const std::vector<JsonKey>& keys) {
    std::vector<std::string> names;
    for (const JsonKey& key : keys)
        if (key.type.schema)
            names.push_back(key.name);
    return names;
}

SchemaJson schemaOf(const JsonKey& key, SchemaJson& definitions) {
    SchemaJson schema = key.type.schema(definitions);
    if (!key.otherwise.empty())
        schema["default"] = SchemaJson::parse(key.otherwise);
    if (!key.description.empty()) {
        schema["description"] =
            key.description + (key.unit.empty() ? "" : " Unit: " + key.unit + ".");
    }
    return schema;
}

} // namespace

JsonKey JsonKey::required() && {
    isRequired = true;
    return std::move(*this);
}

JsonKey JsonKey::in(const std::string& unitName) && {
    unit = unitName;
    return std::move(*this);
}

JsonKey JsonKey::orElse(double number) && {
    otherwise = shortNumber(number);
    return std::move(*this);
}

JsonKey JsonKey::orElse(bool value) && {
    otherwise = value ? "true" : "false";
    return std::move(*this);
}

JsonKey JsonKey::orElseJson(const std::string& json) && {
    otherwise = json;
    return std::move(*this);
}

JsonKey refusedKey(const std::string& name, const std::string& message) {
    return {name, {[=](const JsonValue& value) { value.fail(message); }, {}}, ""};
}

JsonRule exclude(const std::string& a, const std::string& b) {
    return {[=](const JsonObject& object) { object.exclude(a, b); },
            R"({"not": {"required": [")" + a + R"(", ")" + b + R"("]}})"};
}

JsonRule exactlyOne(const std::string& a, const std::string& b) {
    const auto check = [=](const JsonObject& object) {
        object.exclude(a, b);
        if (!object.has(a) && !object.has(b))
            object.value().fail("lacks " + inQuotes(a) + " (or " + inQuotes(b) + ")");
    };
    return {check,
            R"({"oneOf": [{"required": [")" + a + R"("]}, {"required": [")" + b + R"("]}]})"};
}

JsonType JsonObjectType::asType(const std::string& definition) const {
    return namedType(definition, {{}, [type = *this](SchemaJson& definitions) {
                                      return type.schema(definitions);
                                  }});
}

SchemaJson JsonObjectType::schema(SchemaJson& definitions) const {
    SchemaJson properties = SchemaJson::object();
    SchemaJson required = SchemaJson::array();
    for (const JsonKey& key : keys) {
        if (key.type.schema)
            properties[key.name] = schemaOf(key, definitions);
        if (key.isRequired)
            required.push_back(key.name);
    }
    properties[descriptionKey().name] = schemaOf(descriptionKey(), definitions);
    SchemaJson schema = SchemaJson::object();
    if (!description.empty())
        schema["description"] = description;
    schema["type"] = "object";
    schema["additionalProperties"] = false;
    if (!required.empty())
        schema["required"] = std::move(required);
    schema["properties"] = std::move(properties);
    for (const JsonRule& rule : rules)
        schema["allOf"].push_back(SchemaJson::parse(rule.schema));
    return schema;
}

JsonObjectType chosenType(const std::string& name, const std::string& description,
                          std::vector<JsonKey> keys, std::vector<JsonRule> rules) {
    keys.insert(keys.begin(), JsonKey("type", constantType(name, description), "").required());
    return {std::move(keys), std::move(rules), "", name};
}

JsonType anyOf(const JsonObjectTypes& types, const std::string& definition) {
    return namedType(definition, {{}, [=](SchemaJson& definitions) {
                                      SchemaJson schemas = SchemaJson::array();
                                      for (const JsonObjectType& type : types)
                                          schemas.push_back(type.schema(definitions));
                                      return SchemaJson{{"oneOf", schemas}};
                                  }});
}

JsonType objectMapType(const JsonType& object) {
    return {{}, [=](SchemaJson& definitions) {
                const SchemaJson value = object.schema(definitions);
                const std::string& key = descriptionKey().name;
                const SchemaJson described = {
                    {"description", "A text has no effect; an object is one of that name."},
                    {"anyOf", {descriptionKey().type.schema(definitions), value}}};
                return SchemaJson{{"type", "object"},
                                  {"properties", {{key, described}}},
                                  {"additionalProperties", value}};
            }};
}

std::vector<std::string> namesInMap(const JsonValue& map) {
    std::vector<std::string> names;
    for (const auto& [name, value] : map.json().items())
        if (name != descriptionKey().name || !value.is_string())
            names.push_back(name);
    return names;
}

size_t readType(const JsonValue& value, const JsonObjectTypes& types) {
    if (!value.json().is_object())
        value.failType("an object");
    if (!value.json().contains("type")) {
        std::vector<std::string> present;
        for (const auto& [name, unused] : value.json().items())
            present.push_back(name);
        const std::string nearest = nearestName("type", present);
        value.fail("lacks \"type\"" +
                   (nearest.empty() ? "" : "; is " + inQuotes(nearest) + " a misspelling of it?"));
    }
    std::vector<std::string> names;
    for (const JsonObjectType& type : types)
        names.push_back(type.name);
    return value.child("type").choice(names);
}

JsonObject::JsonObject(const JsonValue& value, const JsonObjectType& type)
    : value_(value), type_(&type) {
    if (!value_.json().is_object())
        value_.failType("an object");
    for (const auto& [key, unused] : value_.json().items()) {
        if (key == descriptionKey().name) {
            descriptionKey().type.check(value_.child(key));
        } else if (std::ranges::find(type.keys, key, &JsonKey::name) == type.keys.end()) {
            value_.child(key).fail("unknown key " + inQuotes(key) +
                                   suggestion(key, namesOf(type.keys)));
        }
    }
    for (const JsonKey& key : type.keys)
        if (key.isRequired)
            required(key.name);
    for (const JsonRule& rule : type.rules)
        rule.check(*this);
    for (const JsonKey& key : type.keys)
        if (key.type.check && has(key.name))
            key.type.check(value_.child(key.name));
}

void JsonObject::checkKnown(const std::string& key) const {
    CALOTYPE_CHECK_EQ(std::ranges::count(type_->keys, key, &JsonKey::name), 1);
}

bool JsonObject::has(const std::string& key) const {
    checkKnown(key);
    return value_.json().contains(key);
}

JsonValue JsonObject::required(const std::string& key) const {
    if (!has(key))
        value_.fail("lacks " + inQuotes(key));
    return value_.child(key);
}

std::optional<JsonValue> JsonObject::optional(const std::string& key) const {
    return has(key) ? std::optional(value_.child(key)) : std::nullopt;
}

double JsonObject::number(const std::string& key, double otherwise) const {
    return has(key) ? value_.child(key).number() : otherwise;
}

bool JsonObject::boolean(const std::string& key, bool otherwise) const {
    return has(key) ? value_.child(key).boolean() : otherwise;
}

glm::dvec3 JsonObject::vector(const std::string& key, const glm::dvec3& otherwise) const {
    return has(key) ? value_.child(key).vector() : otherwise;
}

size_t JsonObject::choice(const std::string& key, std::span<const std::string> names,
                          size_t otherwise) const {
    return has(key) ? value_.child(key).choice(names) : otherwise;
}

void JsonObject::exclude(const std::string& a, const std::string& b) const {
    if (has(a) && has(b)) {
        value_.child(b).fail(inQuotes(a) + " and " + inQuotes(b) +
                             " exclude each other; keep one of them");
    }
}

} // namespace calotype
