#include "read/json/override.h"

#include <charconv>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/names.h"
#include "read/json/document.h"

namespace calotype {
namespace {

using Json = nlohmann::json;

/// The command line may contain any bytes.
bool isUtf8(const std::string& text) {
    try {
        Json(text).dump();
        return true;
    } catch (const Json::type_error&) {
        return false;
    }
}

/// False also for indices that nlohmann cannot parse.
bool containsPart(const Json& document, const Json::json_pointer& pointer) {
    try {
        return document.contains(pointer);
    } catch (const Json::exception&) {
        return false;
    }
}

Json parseValue(const std::string& text, const std::string& where) {
    const bool ignoreComments = true;
    return Json::accept(text, ignoreComments) ? parseJson(text, where) : Json(text);
}

/// A decimal index without leading zeros, or nothing.
std::optional<size_t> parseIndex(const std::string& token) {
    size_t index = 0;
    const char* const end = token.data() + token.size();
    const auto [stop, error] = std::from_chars(token.data(), end, index);
    const bool leadingZero = token.size() > 1 && token.front() == '0';
    return error == std::errc() && stop == end && !leadingZero ? std::optional(index)
                                                               : std::nullopt;
}

} // namespace

void applyOverride(Json& document, const SceneOverride& override) {
    const std::string where = "--set " + override.pointer;
    if (!isUtf8(override.pointer) || !isUtf8(override.value))
        throw SceneError(where, "pointer and value must be UTF-8");
    Json::json_pointer pointer;
    try {
        pointer = Json::json_pointer(override.pointer);
    } catch (const Json::parse_error&) {
        throw SceneError(where, "is not a JSON pointer; write it like /materials/gold/roughness, "
                                "with ~0 for ~ and ~1 for / within a name");
    }
    if (pointer.empty())
        throw SceneError(where, "cannot replace the whole scene; name a part, such as /render/spp");
    const Json::json_pointer parentPointer = pointer.parent_pointer();
    if (!containsPart(document, parentPointer)) {
        throw SceneError(where, "the scene has no " + parentPointer.to_string() +
                                    "; set that first, to an object");
    }
    Json& parent = document.at(parentPointer);
    Json value = parseValue(override.value, where);
    const std::string& last = pointer.back();
    if (parent.is_object()) {
        parent[last] = std::move(value);
    } else if (!parent.is_array()) {
        throw SceneError(where, parentPointer.to_string() +
                                    " is neither an object nor an array, so it has no parts");
    } else if (const auto index = parseIndex(last); index && *index < parent.size()) {
        parent[*index] = std::move(value);
    } else if (last == "-") {
        parent.push_back(std::move(value));
    } else {
        throw SceneError(where, "the array has " + std::to_string(parent.size()) +
                                    " elements, so " + inQuotes(last) +
                                    " is not one of them (\"-\" appends)");
    }
}

void applyView(Json& document, const ViewOptions& view) {
    if (view.isEmpty() || !document.is_object())
        return;
    Json& camera = document["camera"];
    if (!camera.is_object())
        camera = Json::object();
    if ((view.from || view.lookAt || view.up) && camera.contains("matrix")) {
        if (!view.from || !view.lookAt)
            throw SceneError(view.from     ? "--from"
                             : view.lookAt ? "--look-at"
                                           : "--up",
                             "the scene's camera is placed by a matrix; give both --from and "
                             "--look-at to place it anew");
        camera.erase("matrix");
    }
    const auto set = [&](const char* key, const std::optional<glm::dvec3>& value) {
        if (value)
            camera[key] = {value->x, value->y, value->z};
    };
    set("position", view.from);
    set("target", view.lookAt);
    set("up", view.up);
    if (view.fov)
        camera["fov"] = *view.fov;
}

} // namespace calotype
