#include "read/json/value.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/names.h"
#include "read/json/document.h"

namespace calotype {
namespace {

std::string describe(const nlohmann::json& json) {
    switch (json.type()) {
    case nlohmann::json::value_t::object:
        return "an object";
    case nlohmann::json::value_t::array:
        return "an array of " + std::to_string(json.size());
    case nlohmann::json::value_t::string:
        return "the text " + inQuotes(json.get_ref<const std::string&>());
    default:
        return json.dump();
    }
}

} // namespace

void JsonValue::fail(const std::string& message) const { throw SceneError(where(), message); }

void JsonValue::failType(const std::string& what) const {
    fail("must be " + what + ", not " + describe(*json_));
}

std::string JsonValue::where() const { return jsonPlace(*file_, pointer_); }

JsonValue JsonValue::child(const std::string& key) const {
    static const nlohmann::json kAbsent;
    const auto found = json_->is_object() ? json_->find(key) : json_->end();
    return {found != json_->end() ? *found : kAbsent, *file_, extendPointer(pointer_, key)};
}

double JsonValue::number() const {
    if (!json_->is_number())
        failType("a number");
    return json_->get<double>();
}

double JsonValue::numberIn(const Range& range) const {
    const double value = number();
    if (!range.contains(value))
        failType(toText(range));
    return value;
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean())
        failType("true or false");
    return json_->get<bool>();
}

const std::string& JsonValue::text() const {
    if (!json_->is_string())
        failType("a text in quotes");
    return json_->get_ref<const std::string&>();
}

uint32_t JsonValue::wholeNumber(const ranges::WholeRange& range) const {
    const double value = json_->is_number() ? json_->get<double>() : std::nan("");
    if (!(value >= range.low && value <= range.high && value == std::floor(value))) {
        failType("a whole number from " + std::to_string(range.low) + " to " +
                 std::to_string(range.high));
    }
    return static_cast<uint32_t>(value);
}

size_t JsonValue::choice(std::span<const std::string> choices) const {
    const auto found = std::find(choices.begin(), choices.end(), text());
    if (found == choices.end()) {
        const std::string nearest = nearestName(text(), choices);
        fail("must be one of " + listInQuotes(choices) + ", not " + inQuotes(text()) +
             (nearest.empty() ? "" : "; did you mean " + inQuotes(nearest) + "?"));
    }
    return static_cast<size_t>(found - choices.begin());
}

std::vector<JsonValue> JsonValue::array() const {
    if (!json_->is_array())
        failType("an array");
    std::vector<JsonValue> elements;
    elements.reserve(json_->size());
    for (size_t i = 0; i < json_->size(); ++i)
        elements.emplace_back((*json_)[i], *file_, extendPointer(pointer_, i));
    return elements;
}

std::vector<JsonValue> JsonValue::array(size_t count) const {
    if (!json_->is_array() || json_->size() != count)
        failType("an array of " + std::to_string(count));
    return array();
}

glm::dvec3 JsonValue::vector() const {
    if (!json_->is_array() || json_->size() != 3)
        failType("an array of 3 numbers");
    const std::vector<JsonValue> elements = array();
    return {elements[0].number(), elements[1].number(), elements[2].number()};
}

glm::dvec3 JsonValue::direction() const {
    const glm::dvec3 v = vector();
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0.0)
        fail("is a direction and must not be zero");
    // Divided first, so that no length overflows or underflows.
    return glm::normalize(v / largest);
}

} // namespace calotype
