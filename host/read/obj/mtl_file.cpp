#include "read/obj/mtl_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "base/lowercase.h"
#include "base/names.h"
#include "base/text_cursor.h"
#include "read/obj/lines.h"

namespace calotype {
namespace {

/// Statements that have no meaning for a path tracer.
constexpr std::array<std::string_view, 4> kWithoutEffect = {"ka", "map_ka", "sharpness", "map_aat"};
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

/// One number for grey, or three.
glm::dvec3 parseColor(TextCursor& cursor, const std::string& where) {
    std::vector<double> numbers;
    while (!cursor.atEnd()) {
        const std::string_view word = cursor.word();
        const std::optional<double> value = parseNumber(word);
        if (!value || !std::isfinite(*value) || *value < 0.0) {
            throw SceneError(where, inQuotes(word) + " must be a number of 0 or greater (spectral "
                                                     "and CIE XYZ colours are not supported yet)");
        }
        numbers.push_back(*value);
    }
    if (numbers.size() == 1)
        return glm::dvec3(numbers[0]);
    if (numbers.size() != 3) {
        throw SceneError(where, "a colour needs one number or three, not " +
                                    std::to_string(numbers.size()));
    }
    return {numbers[0], numbers[1], numbers[2]};
}

/// Reads the first number; ignores what follows it.
double parseFinite(TextCursor& cursor, std::string_view keyword, const std::string& where) {
    std::string_view word = cursor.word();
    if (word == "-halo") // "d -halo" fades towards the outline; it is rendered like plain "d"
        word = cursor.word();
    const std::optional<double> value = parseNumber(word);
    if (!value || !std::isfinite(*value)) {
        throw SceneError(where,
                         inQuotes(keyword) + " needs a finite number, not " + inQuotes(word));
    }
    return *value;
}

struct ColorStatement {
    std::string_view keyword;
    void (*set)(MtlMaterial&, const glm::dvec3&);
};
constexpr ColorStatement kColors[] = {
    {"kd", [](MtlMaterial& m, const glm::dvec3& color) { m.diffuse = color; }},
    {"ks", [](MtlMaterial& m, const glm::dvec3& color) { m.specular = color; }},
    {"ke", [](MtlMaterial& m, const glm::dvec3& color) { m.emission = color; }},
    {"tf", [](MtlMaterial& m, const glm::dvec3& color) { m.filter = color; }},
};

struct NumberStatement {
    std::string_view keyword;
    void (*set)(MtlMaterial&, double);
};
constexpr NumberStatement kNumbers[] = {
    {"ns", [](MtlMaterial& m, double value) { m.exponent = value; }},
    {"d", [](MtlMaterial& m, double value) { m.dissolve = value; }},
    {"tr", [](MtlMaterial& m, double value) { m.transparency = value; }},
    {"ni", [](MtlMaterial& m, double value) { m.ior = value; }},
    {"pr", [](MtlMaterial& m, double value) { m.roughness = value; }},
    {"pm", [](MtlMaterial& m, double value) { m.metallic = value; }},
    {"illum", [](MtlMaterial& m, double value) { m.illumination = value; }},
};

struct TextureStatement {
    std::string_view keyword;
    std::optional<MtlTexture> MtlMaterial::*texture;
};
constexpr TextureStatement kTextures[] = {
    {"map_kd", &MtlMaterial::diffuseMap},  {"map_d", &MtlMaterial::alphaMap},
    {"map_bump", &MtlMaterial::bumpMap},   {"bump", &MtlMaterial::bumpMap},
    {"norm", &MtlMaterial::normalMap},     {"map_pr", &MtlMaterial::roughnessMap},
    {"map_ke", &MtlMaterial::emissionMap},
};

template <typename Statement, size_t Count>
const Statement* findStatement(const Statement (&statements)[Count], std::string_view keyword) {
    const auto* found = std::ranges::find(statements, keyword, &Statement::keyword);
    return found != std::end(statements) ? found : nullptr;
}

void readStatement(MtlMaterial& material, TextCursor& cursor, const std::string& where) {
    const std::string_view written = cursor.word();
    const std::string keyword = lowercase(written);
    if (const auto* color = findStatement(kColors, keyword))
        color->set(material, parseColor(cursor, where));
    else if (const auto* number = findStatement(kNumbers, keyword))
        number->set(material, parseFinite(cursor, written, where));
    else if (const auto* map = findStatement(kTextures, keyword))
        material.*(map->texture) = parseMtlTexture(cursor.rest(), where);
    else if (hasEffect(keyword, cursor))
        material.unsupported.insert(std::string(written));
}

} // namespace

std::map<std::string, MtlMaterial> parseMtl(std::string_view text, const std::string& path) {
    std::map<std::string, MtlMaterial> materials;
    MtlMaterial* current = nullptr;
    forEachObjLine(withoutByteOrderMark(text), [&](size_t number, std::string_view line) {
        if (line.empty() || line.front() == '#')
            return;
        TextCursor cursor(line);
        if (TextCursor name = cursor; lowercase(name.word()) == "newmtl") {
            current = &materials[std::string(trimmed(name.rest()))];
            current->directory = std::filesystem::path(path).parent_path();
        } else if (current != nullptr) { // else ignored: often a title without its '#'
            readStatement(*current, cursor, path + ":" + std::to_string(number));
        }
    });
    return materials;
}

} // namespace calotype
