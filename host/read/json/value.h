#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

namespace calotype {

/// A JSON value that knows its place. Every getter throws SceneError at that place where the value
/// is not what is asked for. Refers to the document and to the file's name, which must outlive it.
class JsonValue {
public:
    JsonValue(const nlohmann::json& json, const std::string& file, std::string pointer = {})
        : json_(&json), file_(&file), pointer_(std::move(pointer)) {}

    /// Throws SceneError at this place.
    [[noreturn]] void fail(const std::string& message) const;

    const nlohmann::json& json() const { return *json_; }
    const std::string& pointer() const { return pointer_; }
    std::string where() const;
    /// The place of the key `key` of this object, whether it exists or not.
    JsonValue child(const std::string& key) const;

    double number() const;
    double positiveNumber() const;
    /// A number in [low, high]; `high` may be infinite.
    double numberIn(double low, double high) const;
    bool boolean() const;
    const std::string& text() const;
    /// A whole number (64.0 counts) in [low, high].
    uint32_t wholeNumber(uint32_t low, uint32_t high) const;
    /// The index in `choices` of this text.
    size_t choice(std::span<const std::string> choices) const;

    /// The elements of an array of exactly `count`.
    std::vector<JsonValue> array(size_t count) const;
    std::vector<JsonValue> array() const;
    glm::dvec3 vector() const;
    /// A vector that is not zero, made one long.
    glm::dvec3 direction() const;

private:
    /// "must be WHAT, not a string".
    [[noreturn]] void failType(const std::string& what) const;

    const nlohmann::json* json_;
    const std::string* file_;
    std::string pointer_;
};

/// A JSON object all of whose keys are known: the constructor throws SceneError for any other, and
/// names the nearest known one.
class JsonObject {
public:
    JsonObject(const JsonValue& value, std::vector<std::string> knownKeys);

    const JsonValue& value() const { return value_; }
    bool has(const std::string& key) const;
    /// Throws SceneError if the key is missing.
    JsonValue required(const std::string& key) const;
    std::optional<JsonValue> optional(const std::string& key) const;

    double number(const std::string& key, double otherwise) const;
    bool boolean(const std::string& key, bool otherwise) const;
    glm::dvec3 vector(const std::string& key, const glm::dvec3& otherwise) const;
    uint32_t wholeNumber(const std::string& key, uint32_t low, uint32_t high,
                         uint32_t otherwise) const;

    /// Throws SceneError if the object has both keys.
    void exclude(const std::string& a, const std::string& b) const;

private:
    void checkKnown(const std::string& key) const;

    JsonValue value_;
    std::vector<std::string> knownKeys_;
};

/// The text at `key`, one of `choices`, before the other keys of the object can be judged.
size_t choiceAt(const JsonValue& object, const std::string& key,
                std::span<const std::string> choices);

} // namespace calotype
