#include "read/json/schema_text.h"

#include <cstddef>

#include <nlohmann/json.hpp>

namespace calotype {
namespace {

constexpr size_t kColumns = 100;
constexpr size_t kIndent = 2;

/// On one line, with blanks after colons and commas.
std::string oneLine(const SchemaJson& json) {
    if (!json.is_structured() || json.empty())
        return json.dump();
    std::string text;
    for (const auto& [key, value] : json.items()) {
        text += (text.empty() ? "" : ", ") +
                (json.is_object() ? SchemaJson(key).dump() + ": " : "") + oneLine(value);
    }
    return json.is_object() ? "{ " + text + " }" : "[" + text + "]";
}

/// `column` is where the text starts on its line.
void write(const SchemaJson& json, size_t indent, size_t column, std::string& text) {
    const std::string line = oneLine(json);
    if (!json.is_structured() || column + line.size() < kColumns) {
        text += line;
        return;
    }
    text += json.is_object() ? "{" : "[";
    bool isFirst = true;
    for (const auto& [key, value] : json.items()) {
        text += (isFirst ? "\n" : ",\n") + std::string(indent + kIndent, ' ');
        const std::string start = json.is_object() ? SchemaJson(key).dump() + ": " : "";
        text += start;
        write(value, indent + kIndent, indent + kIndent + start.size(), text);
        isFirst = false;
    }
    text += "\n" + std::string(indent, ' ') + (json.is_object() ? "}" : "]");
}

} // namespace

std::string schemaText(const SchemaJson& schema) {
    std::string text;
    write(schema, 0, 0, text);
    return text + "\n";
}

} // namespace calotype
