#pragma once

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

} // namespace calotype
