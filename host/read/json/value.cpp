#include "read/json/value.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include <glm/geometric.hpp>

#include "base/check.h"
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
    if (!json_->is_number()) {
        failType("a number");
    }
    return json_->get<double>();
}

double JsonValue::positiveNumber() const {
    const double value = number();
    if (!(value > 0.0)) {
        failType("greater than 0");
    }
    return value;
}

double JsonValue::numberIn(double low, double high) const {
    const double value = number();
    if (!(value >= low && value <= high)) {
        std::ostringstream range;
        if (std::isinf(high)) {
            range << low << " or greater";
        } else {
            range << "in [" << low << ", " << high << "]";
        }
        failType(range.str());
    }
    return value;
}

bool JsonValue::boolean() const {
    if (!json_->is_boolean()) {
        failType("true or false");
    }
    return json_->get<bool>();
}

const std::string& JsonValue::text() const {
    if (!json_->is_string()) {
        failType("a text in quotes");
    }
    return json_->get_ref<const std::string&>();
}

uint32_t JsonValue::wholeNumber(uint32_t low, uint32_t high) const {
    const double value = json_->is_number() ? json_->get<double>() : std::nan("");
    if (!(value >= low && value <= high && value == std::floor(value))) {
        failType("a whole number from " + std::to_string(low) + " to " + std::to_string(high));
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
    if (!json_->is_array()) {
        failType("an array");
    }
    std::vector<JsonValue> elements;
    elements.reserve(json_->size());
    for (size_t i = 0; i < json_->size(); ++i) {
        elements.emplace_back((*json_)[i], *file_, extendPointer(pointer_, i));
    }
    return elements;
}

std::vector<JsonValue> JsonValue::array(size_t count) const {
    if (!json_->is_array() || json_->size() != count) {
        failType("an array of " + std::to_string(count));
    }
    return array();
}

glm::dvec3 JsonValue::vector() const {
    if (!json_->is_array() || json_->size() != 3) {
        failType("an array of 3 numbers");
    }
    const std::vector<JsonValue> elements = array();
    return {elements[0].number(), elements[1].number(), elements[2].number()};
}

glm::dvec3 JsonValue::direction() const {
    const glm::dvec3 v = vector();
    const double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (largest == 0.0) {
        fail("is a direction and must not be zero");
    }
    // Divided first, so that no length overflows or underflows.
    return glm::normalize(v / largest);
}

JsonObject::JsonObject(const JsonValue& value, std::vector<std::string> knownKeys)
    : value_(value), knownKeys_(std::move(knownKeys)) {
    if (!value_.json().is_object()) {
        value_.fail("must be an object, not " + describe(value_.json()));
    }
    for (const auto& [key, unused] : value_.json().items()) {
        if (std::find(knownKeys_.begin(), knownKeys_.end(), key) == knownKeys_.end()) {
            value_.child(key).fail("unknown key " + inQuotes(key) + suggestion(key, knownKeys_));
        }
    }
}

void JsonObject::checkKnown(const std::string& key) const {
    CALOTYPE_CHECK_EQ(std::count(knownKeys_.begin(), knownKeys_.end(), key), 1);
}

bool JsonObject::has(const std::string& key) const {
    checkKnown(key);
    return value_.json().contains(key);
}

JsonValue JsonObject::required(const std::string& key) const {
    if (!has(key)) {
        value_.fail("lacks " + inQuotes(key));
    }
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

uint32_t JsonObject::wholeNumber(const std::string& key, uint32_t low, uint32_t high,
                                 uint32_t otherwise) const {
    return has(key) ? value_.child(key).wholeNumber(low, high) : otherwise;
}

void JsonObject::exclude(const std::string& a, const std::string& b) const {
    if (has(a) && has(b)) {
        value_.child(b).fail(inQuotes(a) + " and " + inQuotes(b) +
                             " exclude each other; keep one of them");
    }
}

size_t choiceAt(const JsonValue& object, const std::string& key,
                std::span<const std::string> choices) {
    if (!object.json().is_object()) {
        object.fail("must be an object, not " + describe(object.json()));
    }
    if (!object.json().contains(key)) {
        std::vector<std::string> present;
        for (const auto& [name, unused] : object.json().items()) {
            present.push_back(name);
        }
        const std::string nearest = nearestName(key, present);
        object.fail("lacks " + inQuotes(key) +
                    (nearest.empty() ? "" : "; is " + inQuotes(nearest) + " a misspelling of it?"));
    }
    return object.child(key).choice(choices);
}

} // namespace calotype
