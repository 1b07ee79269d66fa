#include "read/json/document.h"

#include <algorithm>
#include <vector>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "base/file_kind.h"
#include "base/names.h"

namespace calotype {
namespace {

using Json = nlohmann::json;

constexpr size_t kDeepestNesting = 100;
constexpr size_t kLongestLastRead = 40;
/// nlohmann's number for "number overflow".
constexpr int kNumberOverflow = 406;

/// "LINE:COLUMN" of a byte offset, both counted from 1, columns in characters.
std::string lineAndColumn(std::string_view text, size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const auto line = 1 + std::count(before.begin(), before.end(), '\n');
    const size_t lineStart = before.rfind('\n') + 1; // npos + 1 is 0
    const auto column =
        1 + std::count_if(before.begin() + static_cast<ptrdiff_t>(lineStart), before.end(),
                          [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; });
    return std::to_string(line) + ":" + std::to_string(column);
}

/// nlohmann's message without its prefix; the part of the text that it quotes is shortened.
std::string syntaxMessage(std::string message) {
    const size_t prefixEnd = message.find("syntax error");
    if (prefixEnd != std::string::npos)
        message.erase(0, prefixEnd);
    const std::string opening = "; last read: '";
    const size_t start = message.find(opening);
    if (start != std::string::npos) {
        const size_t textStart = start + opening.size();
        const size_t textEnd = message.rfind('\'', std::min(message.size(), message.rfind("'; ")));
        if (textEnd != std::string::npos && textEnd > textStart + kLongestLastRead)
            message.replace(textStart, textEnd - textStart - kLongestLastRead, "...");
    }
    return message;
}

/// Whether a JSON value or a comment may start with this character.
bool startsJson(char c) {
    return std::string_view("{[\"/-0123456789tfn").find(c) != std::string_view::npos;
}

/// Offset of the last byte before `end` that is not blank and not part of a comment; npos if there
/// is none. Strings count as one byte: their closing quote.
size_t lastSignificant(std::string_view text, size_t end) {
    size_t last = std::string_view::npos;
    for (size_t i = 0; i < end; ++i)
        if (text.substr(i).starts_with("//"))
            i = std::min(text.find('\n', i), end);
        else if (text.substr(i).starts_with("/*"))
            i = std::min(text.find("*/", i + 2), end - 1) + 1;
        else if (text[i] == '"') {
            for (++i; i < end && text[i] != '"'; ++i)
                if (text[i] == '\\')
                    ++i;
            last = i;
        } else if (std::string_view(" \t\r\n").find(text[i]) == std::string_view::npos)
            last = i;
    return last;
}

/// Builds the document from the parser's events; rejects what nlohmann's own builder accepts.
class DocumentBuilder final : public nlohmann::json_sax<Json> {
public:
    DocumentBuilder(std::string_view text, const std::string& name) : text_(text), name_(name) {}

    Json takeRoot() { return std::move(root_); }

    bool null() override { return add(nullptr); }
    bool boolean(bool value) override { return add(value); }
    bool number_integer(number_integer_t value) override { return add(value); }
    bool number_unsigned(number_unsigned_t value) override { return add(value); }
    bool number_float(number_float_t value, const string_t&) override { return add(value); }
    bool string(string_t& value) override { return add(std::move(value)); }
    bool binary(binary_t&) override { return false; }

    bool start_object(size_t) override { return open(Json::object()); }
    bool start_array(size_t) override { return open(Json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        Level& level = levels_.back();
        if (level.container->contains(key)) {
            throw SceneError(jsonPlace(name_, extendPointer(pointer(levels_.size() - 1), key)),
                             "the key " + inQuotes(key) + " is repeated; keep one of them");
        }
        level.key = std::move(key);
        return true;
    }

    bool parse_error(size_t position, const std::string& lastToken,
                     const Json::exception& error) override {
        if (error.id == kNumberOverflow) {
            throw SceneError(jsonPlace(name_, pointerOfNext()),
                             "the number " + inQuotes(lastToken) +
                                 " is larger than any that can be held");
        }
        const size_t offset = std::min(position > 0 ? position - 1 : 0, text_.size());
        if (offset < text_.size() && (text_[offset] == '}' || text_[offset] == ']')) {
            const size_t last = lastSignificant(text_, offset);
            if (last != std::string_view::npos && text_[last] == ',')
                throw SceneError(name_ + ":" + lineAndColumn(text_, last),
                                 "there is a comma after the last value; remove it");
        }
        throw SceneError(name_ + ":" + lineAndColumn(text_, offset), syntaxMessage(error.what()));
    }

private:
    /// An open container; `key` is that of the next value (objects only).
    struct Level {
        Json* container;
        std::string key;
    };

    Json* append(Json value) {
        if (levels_.empty()) {
            root_ = std::move(value);
            return &root_;
        }
        Level& level = levels_.back();
        if (level.container->is_array()) {
            level.container->push_back(std::move(value));
            return &level.container->back();
        }
        Json& slot = (*level.container)[level.key];
        slot = std::move(value);
        return &slot;
    }

    bool add(Json value) {
        append(std::move(value));
        return true;
    }

    bool open(Json container) {
        if (levels_.size() == kDeepestNesting) {
            throw SceneError(jsonPlace(name_, pointer(1)), "values are nested more than " +
                                                               std::to_string(kDeepestNesting) +
                                                               " deep");
        }
        levels_.push_back({append(std::move(container)), {}});
        return true;
    }

    bool close() {
        levels_.pop_back();
        return true;
    }

    /// Pointer to the container at `depth`; that of the root is 0.
    std::string pointer(size_t depth) const {
        std::string result;
        for (size_t i = 0; i < depth && i < levels_.size(); ++i) {
            const Level& level = levels_[i];
            result = level.container->is_array()
                         ? extendPointer(result, level.container->size() - 1)
                         : extendPointer(result, level.key);
        }
        return result;
    }

    std::string pointerOfNext() const {
        if (levels_.empty())
            return {};
        const Level& level = levels_.back();
        const std::string parent = pointer(levels_.size() - 1);
        return level.container->is_array() ? extendPointer(parent, level.container->size())
                                           : extendPointer(parent, level.key);
    }

    std::string_view text_;
    const std::string& name_;
    Json root_;
    std::vector<Level> levels_;
};

} // namespace

Json parseJson(std::string_view text, const std::string& name) {
    if (text.empty())
        throw SceneError(name + ":1:1", "the file is empty; a JSON object is expected");
    if (const std::string_view kind = fileKind(text); !kind.empty())
        throw SceneError(name,
                         "is " + std::string(kind) + ", and not a scene (JSON) or a model (OBJ)");
    const size_t start = text.find_first_not_of(" \t\r\n\xEF\xBB\xBF"); // a byte order mark
    if (start != std::string_view::npos && !startsJson(text[start]))
        throw SceneError(name, "is neither a scene (JSON), which starts with {, nor a model (OBJ)");
    DocumentBuilder builder(text, name);
    const bool strict = true;
    const bool ignoreComments = true;
    Json::sax_parse(text, &builder, Json::input_format_t::json, strict, ignoreComments);
    return builder.takeRoot();
}

std::string jsonPlace(const std::string& name, const std::string& pointer) {
    return pointer.empty() ? name : name + ": " + pointer;
}

std::string extendPointer(const std::string& pointer, std::string_view key) {
    std::string result = pointer + "/";
    for (const char c : printable(key))
        if (c == '~')
            result += "~0";
        else if (c == '/')
            result += "~1";
        else
            result += c;
    return result;
}

std::string extendPointer(const std::string& pointer, size_t index) {
    return pointer + "/" + std::to_string(index);
}

} // namespace calotype
