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

/// One key of an object of a scene file: what the reader accepts and what the schema says.
struct JsonKey {
    JsonKey(std::string keyName, JsonType keyType, std::string keyDescription)
        : name(std::move(keyName)), type(std::move(keyType)),
          description(std::move(keyDescription)) {}

    JsonKey required() &&;
    /// "metres"
    JsonKey in(const std::string& unitName) &&;
    /// The value that the reader takes where the key is absent.
    JsonKey orElse(double number) &&;
    JsonKey orElse(bool value) &&;
    /// The value as JSON, such as "[0, 1, 0]" or "\"box\"".
    JsonKey orElseJson(const std::string& json) &&;

    std::string name;
    JsonType type;
    std::string description;
    std::string unit;
    std::string otherwise; ///< as JSON; empty where there is none
    bool isRequired = false;
};

/// A key that is refused with a message of its own, and that the schema does not have.
JsonKey refusedKey(const std::string& name, const std::string& message);

/// A rule about more than one key.
struct JsonRule {
    std::function<void(const JsonObject&)> check; ///< throws SceneError
    std::string schema;                           ///< the same as JSON Schema
};

/// At most one of two keys.
JsonRule exclude(const std::string& a, const std::string& b);
/// One of two keys.
JsonRule exactlyOne(const std::string& a, const std::string& b);

/// The keys that an object may have.
struct JsonObjectType {
    std::vector<JsonKey> keys;
    std::vector<JsonRule> rules = {};
    std::string description = {};
    std::string name = {}; ///< the value of "type", where that chooses among several

    /// As a value of a key. The schema defines it under `definition`.
    JsonType asType(const std::string& definition) const;
    SchemaJson schema(SchemaJson& definitions) const;
};

/// Objects of which the key "type" chooses one.
using JsonObjectTypes = std::vector<JsonObjectType>;

/// An object type that "type": "`name`" chooses.
JsonObjectType chosenType(const std::string& name, const std::string& description,
                          std::vector<JsonKey> keys, std::vector<JsonRule> rules = {});

/// Any of `types` as a value of a key.
JsonType anyOf(const JsonObjectTypes& types, const std::string& definition);

/// The index in `types` of what "type" names.
size_t readType(const JsonValue& value, const JsonObjectTypes& types);

/// A JSON object of a known type. The constructor throws SceneError for unknown keys, and names the
/// nearest known one, for missing ones, for broken rules and for values that are not of their type.
class JsonObject {
public:
    /// Refers to `type`, which must outlive it.
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
