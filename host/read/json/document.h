#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace calotype {

/// Parses JSON with // and /* */ comments. Throws SceneError at "NAME:LINE:COLUMN" for syntax
/// errors, and at "NAME: /json/pointer" for repeated keys, for numbers that a double cannot hold
/// and for values nested more than 100 deep.
nlohmann::json parseJson(std::string_view text, const std::string& name);

/// "NAME: POINTER", or just the name for the whole document.
std::string jsonPlace(const std::string& name, const std::string& pointer);

/// `pointer` with one more reference token, escaped as in RFC 6901. For messages: control
/// characters are escaped and long keys shortened.
std::string extendPointer(const std::string& pointer, std::string_view key);
std::string extendPointer(const std::string& pointer, size_t index);

} // namespace calotype
