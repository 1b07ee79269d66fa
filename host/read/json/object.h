#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "read/json/type.h"
#include "read/json/value.h"

namespace calotype {

class JsonObject;

/// One key of an object of a scene file: what the reader accepts and the schema describes.
struct JsonKey {
    JsonKey(std::string keyName, JsonType keyType, std::string keyDescription)
        : name(std::move(keyName)), type(std::move(keyType)),
          description(std::move(keyDescription)) {}

    JsonKey required() &&;
    /// Sets the unit, such as "metres".
    JsonKey in(const std::string& unitName) &&;
    /// Sets the default, used if the key is absent.
    JsonKey orElse(double number) &&;
    JsonKey orElse(bool value) &&;
    /// Sets the default as JSON, such as "[0, 1, 0]" or "\"box\"".
    JsonKey orElseJson(const std::string& json) &&;

    std::string name;
    JsonType type;
    std::string description;
    std::string unit;
    std::string otherwise; ///< as JSON; empty if there is none
    bool isRequired = false;
};

/// A key that the schema does not have, and that is rejected with its own message.
JsonKey refusedKey(const std::string& name, const std::string& message);

/// A rule about more than one key.
struct JsonRule {
    std::function<void(const JsonObject&)> check; ///< throws SceneError
    std::string schema;                           ///< the same rule as JSON Schema
};

/// At most one of two keys is allowed.
JsonRule exclude(const std::string& a, const std::string& b);
/// Exactly one of two keys is required.
JsonRule exactlyOne(const std::string& a, const std::string& b);

/// The keys that an object may have.
struct JsonObjectType {
    std::vector<JsonKey> keys;
    std::vector<JsonRule> rules = {};
    std::string description = {};
    std::string name = {}; ///< the value of "type", if that chooses among several types

    /// The type as value of a key. The schema defines it under `definition`.
    JsonType asType(const std::string& definition) const;
    SchemaJson schema(SchemaJson& definitions) const;
};

/// Types of objects; the key "type" chooses one of them.
using JsonObjectTypes = std::vector<JsonObjectType>;

/// An object type that "type": "`name`" chooses.
JsonObjectType chosenType(const std::string& name, const std::string& description,
                          std::vector<JsonKey> keys, std::vector<JsonRule> rules = {});

/// Any of `types`, as value of a key.
JsonType anyOf(const JsonObjectTypes& types, const std::string& definition);

/// An object whose keys are names of objects that the author chooses. A text "description" in it is
/// no such object and has no effect.
JsonType objectMapType(const JsonType& object);

/// The names in a value of objectMapType, in order.
std::vector<std::string> namesInMap(const JsonValue& map);

/// The index in `types` of the type that "type" names.
size_t readType(const JsonValue& value, const JsonObjectTypes& types);

/// A JSON object of a known type. The constructor throws SceneError for unknown keys, with the
/// nearest known one, for missing keys, for broken rules and for values of a wrong type.
class JsonObject {
public:
    /// `type` must outlive this object.
    JsonObject(const JsonValue& value, const JsonObjectType& type);

    const JsonValue& value() const { return value_; }
    bool has(const std::string& key) const;
    /// Throws SceneError if the key is missing.
    JsonValue required(const std::string& key) const;
    std::optional<JsonValue> optional(const std::string& key) const;

    double number(const std::string& key, double otherwise) const;
    bool boolean(const std::string& key, bool otherwise) const;
    glm::dvec3 vector(const std::string& key, const glm::dvec3& otherwise) const;
    /// The index in `names` of the text at `key`.
    size_t choice(const std::string& key, std::span<const std::string> names,
                  size_t otherwise) const;

    /// Throws SceneError if the object has both keys.
    void exclude(const std::string& a, const std::string& b) const;

private:
    void checkKnown(const std::string& key) const;

    JsonValue value_;
    const JsonObjectType* type_;
};

} // namespace calotype
