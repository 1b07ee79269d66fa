#include "scene/mtl_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "base/error.h"
#include "scene/names.h"
#include "scene/obj_lines.h"
#include "scene/text_cursor.h"

namespace calotype {
namespace {

/// Statements that mean nothing by themselves, or nothing to a path tracer.
constexpr std::array<std::string_view, 4> kWithoutEffect = {"Ka", "illum", "Ns", "Ni"};

struct NeutralStatement {
    std::string_view keyword;
    double value;
};

/// Statements that ask for nothing when all their numbers are these.
constexpr std::array<NeutralStatement, 4> kNeutral = {
    {{"Ks", 0.0}, {"d", 1.0}, {"Tr", 0.0}, {"Tf", 1.0}}};

bool hasEffect(std::string_view keyword, TextCursor arguments) {
    if (std::find(kWithoutEffect.begin(), kWithoutEffect.end(), keyword) != kWithoutEffect.end()) {
        return false;
    }
    const auto neutral = std::find_if(kNeutral.begin(), kNeutral.end(),
                                      [&](const auto& n) { return n.keyword == keyword; });
    if (neutral == kNeutral.end()) {
        return true;
    }
    while (!arguments.atEnd()) {
        if (parseNumber(arguments.word()) != neutral->value) {
            return true;
        }
    }
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
    if (numbers.size() == 1) {
        return glm::dvec3(numbers[0]);
    }
    if (numbers.size() != 3) {
        throw SceneError(where, "a colour needs one number or three, not " +
                                    std::to_string(numbers.size()));
    }
    return {numbers[0], numbers[1], numbers[2]};
}

} // namespace

std::map<std::string, MtlMaterial> parseMtl(std::string_view text, const std::string& path) {
    std::map<std::string, MtlMaterial> materials;
    MtlMaterial* current = nullptr;
    forEachObjLine(withoutByteOrderMark(text), [&](size_t number, std::string_view line) {
        if (line.empty() || line.front() == '#') {
            return;
        }
        const std::string where = path + ":" + std::to_string(number);
        TextCursor cursor(line);
        const std::string_view keyword = cursor.word();
        if (keyword == "newmtl") {
            current = &materials[std::string(trimmed(cursor.rest()))];
        } else if (current == nullptr) {
            return; // belongs to no material: often a title without its '#'
        } else if (keyword == "Kd") {
            current->color = parseColor(cursor, where);
        } else if (keyword == "Ke") {
            current->emission = parseColor(cursor, where);
        } else if (hasEffect(keyword, cursor)) {
            current->unsupported.insert(std::string(keyword));
        }
    });
    return materials;
}

} // namespace calotype
