#include "read/obj/mtl_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "base/error.h"
#include "base/lowercase.h"
#include "base/text_cursor.h"
#include "read/obj/lines.h"
#include "read/obj/readings.h"

namespace calotype {
namespace {

constexpr const char* kUnreadable =
    "statements whose numbers are missing, not finite or cannot be read, which were ignored";
constexpr const char* kWordsBehind = "statements with words behind their numbers, which were "
                                     "ignored";
constexpr const char* kOtherColorSpaces =
    "spectral and CIE XYZ colours, which are not supported and were ignored";
constexpr const char* kRepeated =
    "materials that are defined again, of which the first definition is used";
constexpr const char* kNoFileName = "texture statements without a file name, which were ignored";
constexpr const char* kBadOptions =
    "texture statements whose options cannot be read, which were ignored";
constexpr const char* kLimitedOptions =
    "texture statements with numbers out of range, which were limited";

/// Statements that have no meaning for a path tracer.
constexpr std::array<std::string_view, 3> kWithoutEffect = {"map_ka", "sharpness", "map_aat"};
/// Statements without effect when all their numbers are 0.
constexpr std::array<std::string_view, 6> kNeutralAtZero = {"kt",  "ps",    "pc",
                                                            "pcr", "aniso", "anisor"};

bool isAmong(std::string_view word, std::span<const std::string_view> words) {
    return std::ranges::find(words, word) != words.end();
}

bool hasEffect(std::string_view keyword, TextCursor arguments) {
    if (isAmong(keyword, kWithoutEffect))
        return false;
    if (!isAmong(keyword, kNeutralAtZero))
        return true;
    while (!arguments.atEnd())
        if (parseNumber(arguments.word()) != 0.0)
            return true;
    return false;
}

/// The finite numbers up to the first other word, which is left in the cursor.
std::vector<double> readNumbers(TextCursor& cursor, size_t most) {
    std::vector<double> numbers;
    while (!cursor.atEnd() && numbers.size() < most) {
        TextCursor next = cursor;
        const std::optional<double> value = parseNumber(next.word());
        if (!value || !std::isfinite(*value))
            break;
        numbers.push_back(*value);
        cursor = next;
    }
    return numbers;
}

struct ColorStatement {
    std::string_view keyword;
    std::optional<glm::dvec3> MtlMaterial::*color;
};
constexpr ColorStatement kColors[] = {
    {"ka", &MtlMaterial::ambient},  {"kd", &MtlMaterial::diffuse}, {"ks", &MtlMaterial::specular},
    {"ke", &MtlMaterial::emission}, {"tf", &MtlMaterial::filter},
};

struct NumberStatement {
    std::string_view keyword;
    std::optional<double> MtlMaterial::*number;
};
constexpr NumberStatement kNumbers[] = {
    {"ns", &MtlMaterial::exponent},        {"d", &MtlMaterial::dissolve},
    {"tr", &MtlMaterial::transparency},    {"ni", &MtlMaterial::ior},
    {"pr", &MtlMaterial::roughness},       {"pm", &MtlMaterial::metallic},
    {"illum", &MtlMaterial::illumination},
};

struct TextureStatement {
    std::string_view keyword;
    std::optional<MtlTexture> MtlMaterial::*texture;
    bool isOnlyFromBlender = false;
};
constexpr TextureStatement kTextures[] = {
    {"map_kd", &MtlMaterial::diffuseMap},
    {"map_d", &MtlMaterial::alphaMap},
    {"map_bump", &MtlMaterial::bumpMap},
    {"bump", &MtlMaterial::bumpMap},
    {"norm", &MtlMaterial::normalMap},
    {"map_pr", &MtlMaterial::roughnessMap},
    {"map_pm", &MtlMaterial::metallicMap},
    {"map_ke", &MtlMaterial::emissionMap},
    {"map_ns", &MtlMaterial::exponentMap, true},
    {"map_ks", &MtlMaterial::specularMap, true},
    {"map_refl", &MtlMaterial::reflectionMap, true},
    {"refl", &MtlMaterial::reflectionMap, true},
};

template <typename Statement, size_t Count>
const Statement* findStatement(const Statement (&statements)[Count], std::string_view keyword) {
    const auto* found = std::ranges::find(statements, keyword, &Statement::keyword);
    return found != std::end(statements) ? found : nullptr;
}

/// "# Blender 4.2.0 MTL File: 'chair.blend'", before 3.1 without the version.
bool isFromBlender(std::string_view text) {
    std::string_view first = trimmed(text.substr(0, text.find_first_of("\r\n")));
    if (!first.starts_with('#'))
        return false;
    first.remove_prefix(1);
    first = trimmed(first);
    return first.starts_with("Blender") && first.find("MTL File") != first.npos;
}

class MtlReader {
public:
    MtlReader(const std::string& path, const FileExists& exists, bool isFromBlender)
        : directory_(std::filesystem::path(path).parent_path()), path_(path), exists_(exists),
          isFromBlender_(isFromBlender) {}

    void readLine(size_t number, std::string_view line) {
        number_ = number;
        TextCursor cursor(line);
        if (cursor.atEnd())
            return;
        const std::string_view written = cursor.word();
        const std::string keyword = lowercase(written);
        if (keyword == "newmtl")
            beginMaterial(std::string(trimmed(cursor.rest())));
        else if (current_ != nullptr) // else ignored: often a title without its '#'
            readStatement(keyword, written, cursor);
    }

    MtlFile takeFile() { return std::move(file_); }

private:
    /// As between files, the first material of a name is used. The statements of others are
    /// ignored.
    void beginMaterial(const std::string& name) {
        const auto [entry, isNew] = file_.materials.try_emplace(name);
        current_ = isNew ? &entry->second : nullptr;
        if (!isNew)
            return remark(kRepeated);
        current_->directory = directory_;
        current_->isFromBlender = isFromBlender_;
    }

    void remark(const char* sentence) { file_.remarks[sentence].add(number_); }

    void readStatement(const std::string& keyword, std::string_view written, TextCursor& cursor) {
        const auto* map = findStatement(kTextures, keyword);
        if (const auto* color = findStatement(kColors, keyword))
            readColor(current_->*(color->color), cursor);
        else if (const auto* number = findStatement(kNumbers, keyword))
            readNumber(current_->*(number->number), cursor);
        else if (map != nullptr && (isFromBlender_ || !map->isOnlyFromBlender))
            readTexture(current_->*(map->texture), cursor.rest());
        else if (hasEffect(keyword, cursor))
            current_->unsupported.emplace(keyword, written);
    }

    /// One number for grey, or three.
    void readColor(std::optional<glm::dvec3>& color, TextCursor& cursor) {
        const std::string first = lowercase(TextCursor(cursor).word());
        if (first == "spectral" || first == "xyz")
            return remark(kOtherColorSpaces);
        const std::vector<double> numbers = readNumbers(cursor, 4); // the fourth is an alpha
        if (numbers.size() != 1 && numbers.size() < 3)
            return remark(kUnreadable);
        if (!cursor.atEnd() && numbers.size() < 3)
            return remark(kUnreadable);
        noteWordsBehind(cursor);
        color = numbers.size() == 1 ? glm::dvec3(numbers[0])
                                    : glm::dvec3(numbers[0], numbers[1], numbers[2]);
    }

    void readNumber(std::optional<double>& number, TextCursor& cursor) {
        TextCursor afterHalo = cursor;
        if (afterHalo.word() == "-halo") // fades towards the outline; rendered like plain "d"
            cursor = afterHalo;
        const std::vector<double> numbers = readNumbers(cursor, 1);
        if (numbers.empty())
            return remark(kUnreadable);
        noteWordsBehind(cursor);
        number = numbers.front();
    }

    void noteWordsBehind(const TextCursor& cursor) {
        if (!cursor.atEnd())
            remark(kWordsBehind);
    }

    void readTexture(std::optional<MtlTexture>& texture, std::string_view text) {
        try {
            const std::optional<MtlTexture> read = parseTexture(text);
            if (!read)
                return remark(kNoFileName);
            if (read->isLimited)
                remark(kLimitedOptions);
            texture = read;
        } catch (const SceneError&) {
            remark(kBadOptions);
        }
    }

    /// A '#' after a blank starts a comment unless it belongs to the name of a file. If no reading
    /// names a file, the shortest one with an extension is used, for the message.
    std::optional<MtlTexture> parseTexture(std::string_view text) {
        const std::string place = path_ + ":" + std::to_string(number_);
        if (withoutComment(text) == trimmed(text))
            return parseMtlTexture(text, place);
        std::optional<MtlTexture> missing;
        for (const std::string_view reading : readingsOf(text)) {
            const auto texture = parseReading(reading, place);
            if (texture && exists_(texture->file))
                return texture;
            if (texture && std::filesystem::path(texture->file).has_extension())
                missing = texture;
        }
        return missing ? missing : parseMtlTexture(withoutComment(text), place);
    }

    static std::optional<MtlTexture> parseReading(std::string_view text, const std::string& place) {
        try {
            return parseMtlTexture(text, place);
        } catch (const SceneError&) {
            return std::nullopt;
        }
    }

    MtlFile file_;
    const std::filesystem::path directory_;
    const std::string& path_;
    const FileExists& exists_;
    const bool isFromBlender_;
    MtlMaterial* current_ = nullptr;
    size_t number_ = 0; ///< of the line at hand
};

} // namespace

MtlFile parseMtl(std::string_view text, const std::string& path, const FileExists& exists) {
    text = withoutByteOrderMark(text);
    MtlReader reader(path, exists, isFromBlender(text));
    forEachObjLine(text,
                   [&](size_t number, std::string_view line) { reader.readLine(number, line); });
    return reader.takeFile();
}

} // namespace calotype
