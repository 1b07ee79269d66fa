#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>

#include "base/range.h"
#include "scene/ranges.h"

namespace calotype {

/// A JSON value with its place. Every getter throws SceneError at that place if the value has
/// another type. Refers to the document and to the file's name, which must outlive it.
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
    double numberIn(const Range& range) const;
    bool boolean() const;
    const std::string& text() const;
    /// 64.0 counts as a whole number.
    uint32_t wholeNumber(const ranges::WholeRange& range) const;
    /// The index of this text in `choices`.
    size_t choice(std::span<const std::string> choices) const;

    /// The elements of an array, which must have exactly `count`.
    std::vector<JsonValue> array(size_t count) const;
    std::vector<JsonValue> array() const;
    glm::dvec3 vector() const;
    /// A vector that is not zero, normalised.
    glm::dvec3 direction() const;

    /// Throws "must be WHAT, not the text "a"".
    [[noreturn]] void failType(const std::string& what) const;

private:
    const nlohmann::json* json_;
    const std::string* file_;
    std::string pointer_;
};

} // namespace calotype
