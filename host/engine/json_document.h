#pragma once

#include <string>

#include <nlohmann/json.hpp>

namespace calotype {

/// Version of the format of all JSON that the program writes (docs/json.md). It grows when a key
/// changes its meaning or is removed, not when one is added.
inline constexpr int kJsonFormat = 1;

/// A document with its first keys: "format", and "version" of the program.
inline nlohmann::ordered_json newJsonDocument() {
    nlohmann::ordered_json json;
    json["format"] = kJsonFormat;
    json["version"] = CALOTYPE_VERSION;
    return json;
}

/// The document as text; names of files and materials may hold bytes that are not UTF-8, which
/// become the replacement character. An `indent` of -1 makes one line.
inline std::string jsonText(const nlohmann::ordered_json& json, int indent = 2) {
    return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

} // namespace calotype
