#include "read/obj/outline.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/lowercase.h"
#include "base/names.h"
#include "base/text_cursor.h"
#include "read/obj/lines.h"
#include "read/obj/tinyobj_text.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

constexpr std::array<const char*, kObjDataCount> kNames = {"position", "texture coordinate",
                                                           "normal"};
constexpr std::array<const char*, kObjDataCount> kKeywords = {"v", "vt", "vn"};
constexpr std::array<int, kObjDataCount> kFewestNumbers = {3, 1, 3};
/// Further numbers (weights, colours) are not used, but they must still be numbers.
constexpr std::array<int, kObjDataCount> kUsedNumbers = {3, 2, 3};
/// Position and colour. The colour may follow a weight.
constexpr int kNumbersWithColor = 6;

/// Statements that show something in other programs: points, lines, curves, surfaces, patches,
/// texture maps of faces, and further files.
constexpr std::array<std::string_view, 14> kUnrendered = {
    "p",   "l",   "curv", "curv2",  "surf",   "fo",        "bzp",
    "bsp", "cdc", "cdp",  "usemap", "maplib", "trace_obj", "call"};

class OutlineReader {
public:
    ObjOutline read(std::string_view text, const OnProgress& onProgress) {
        const size_t lines = lineCount(text);
        forEachObjLine(text, [&](size_t number, std::string_view line) {
            number_ = number;
            reportStep(onProgress, number, lines);
            addLine(line);
        });
        for (size_t kind = 0; kind < kObjDataCount; ++kind)
            if (largestIndex_[kind] > static_cast<int64_t>(outline_.counts[kind]))
                outline_.hasBadIndices = true;
        return std::move(outline_);
    }

private:
    void addLine(std::string_view line) {
        if (line.empty())
            return;
        if (line.front() == '#') {
            if (line.starts_with("#MRGB")) // colours of vertices, by ZBrush
                outline_.coloredLines.add(number_);
            return;
        }
        TextCursor cursor(line);
        const std::string keyword = objKeyword(cursor);
        outline_.needsRewriting = outline_.needsRewriting || !line.starts_with(keyword);
        if (keyword == "v") {
            addVertexData(kObjPosition, cursor);
        } else if (keyword == "vt") {
            addVertexData(kObjTexcoord, cursor);
        } else if (keyword == "vn") {
            addVertexData(kObjNormal, cursor);
        } else if (keyword == "f") {
            addFace(cursor);
        } else if (keyword == "usemtl") {
            material_ = trimmed(cursor.rest());
            materialChanged_ = true;
        } else if (keyword == "s") {
            smoothingGroup_ = groupOf(cursor.word());
        } else if (keyword == "mtllib") {
            outline_.libraries.emplace_back(trimmed(cursor.rest()));
        } else if (keyword == "vc") {
            outline_.coloredLines.add(number_);
        } else if (std::ranges::find(kUnrendered, keyword) != kUnrendered.end()) {
            addUnrendered(keyword);
        }
    }

    void addVertexData(ObjData kind, TextCursor& cursor) {
        const size_t index = outline_.counts[kind]++;
        if (cursor.atEnd()) {
            outline_.needsRewriting = true;
            addUnreadable(kind, index,
                          std::string("\"") + kKeywords[kind] + "\" lacks its numbers");
            return;
        }
        int numbers = 0;
        bool isUsable = true;
        bool isZero = true;
        for (; !cursor.atEnd(); ++numbers) {
            const std::string_view word = cursor.word();
            const std::optional<double> value = parseNumber(word);
            outline_.needsRewriting =
                outline_.needsRewriting || !value || !tinyobjReadsNumber(word);
            if (!value) {
                addUnreadable(kind, index, inQuotes(word) + " is not a number");
                return;
            }
            if (numbers >= kUsedNumbers[kind])
                continue;
            isUsable = isUsable && std::isfinite(*value) &&
                       (kind != kObjTexcoord || ranges::kTextureCoordinate.contains(*value));
            isZero = isZero && *value == 0.0;
        }
        if (numbers < kFewestNumbers[kind]) {
            addUnreadable(kind, index,
                          std::string("a ") + kNames[kind] + " needs " +
                              std::to_string(kFewestNumbers[kind]) + " numbers, not " +
                              std::to_string(numbers));
        } else if (!isUsable || (kind == kObjNormal && isZero)) {
            addUnusable(kind, index);
        }
        if (kind == kObjPosition && numbers >= kNumbersWithColor)
            outline_.coloredLines.add(number_);
    }

    void addUnreadable(ObjData kind, size_t index, const std::string& message) {
        addUnusable(kind, index);
        outline_.unreadable[kind].emplace_hint(outline_.unreadable[kind].end(), index,
                                               ObjOutline::Unreadable{number_, message});
    }

    void addUnusable(ObjData kind, size_t index) {
        outline_.isUnusable[kind].resize(index + 1);
        outline_.isUnusable[kind][index] = true;
    }

    void addFace(const TextCursor& cursor) {
        const bool isReadable = parseObjFace(cursor, face_);
        if (!isReadable || face_.size() < 3) {
            (isReadable ? outline_.smallFaces : outline_.unreadableFaces).add(number_);
            outline_.needsRewriting = true; // to leave it out
            return;
        }
        for (const ObjCorner& corner : face_)
            for (size_t kind = 0; kind < kObjDataCount; ++kind)
                if (corner[kind])
                    addIndex(ObjData(kind), *corner[kind]);
        outline_.hasPartialFaces = outline_.hasPartialFaces || isPartial(face_, kObjTexcoord) ||
                                   isPartial(face_, kObjNormal);
        outline_.needsRewriting = outline_.needsRewriting || isMisreadByTinyobj(cursor.rest());
        noteMaterial();
        noteSmoothing();
        ++outline_.polygons;
        outline_.corners += face_.size();
    }

    /// Comments and empty last fields are misread. `corners` are readable.
    static bool isMisreadByTinyobj(std::string_view corners) {
        return corners.find('#') != corners.npos || corners.find("/ ") != corners.npos ||
               corners.find("/\t") != corners.npos || corners.ends_with('/');
    }

    void addIndex(ObjData kind, int64_t index) {
        const auto count = static_cast<int64_t>(outline_.counts[kind]);
        outline_.hasBadIndices = outline_.hasBadIndices || index == 0 || index < -count;
        largestIndex_[kind] = std::max(largestIndex_[kind], index);
        outline_.needsRewriting = outline_.needsRewriting || !tinyobjReadsIndex(index);
    }

    void noteMaterial() {
        if (!materialChanged_)
            return;
        materialChanged_ = false;
        uint32_t material = ObjOutline::kNoMaterial;
        if (!material_.empty()) {
            const auto next = static_cast<uint32_t>(outline_.materialNames.size());
            material = materialIndex_.try_emplace(material_, next).first->second;
            if (material == next) {
                outline_.materialNames.push_back(material_);
                outline_.materialLines.push_back(number_);
            }
        }
        outline_.materialRuns.push_back({outline_.polygons, material});
    }

    /// The number of the group that `name` names: 0 for "0" and "off", else from 1.
    uint32_t groupOf(std::string_view name) {
        if (name.empty() || parseNumber(name) == 0.0 || lowercase(name) == "off")
            return 0;
        const auto next = static_cast<uint32_t>(groupIndex_.size() + 1);
        return groupIndex_.try_emplace(std::string(name), next).first->second;
    }

    void noteSmoothing() {
        const auto& runs = outline_.smoothingRuns;
        if (smoothingGroup_ != (runs.empty() ? 0 : runs.back().group))
            outline_.smoothingRuns.push_back({outline_.polygons, smoothingGroup_});
    }

    void addUnrendered(const std::string& keyword) {
        outline_.unrendered.add(number_);
        auto& keywords = outline_.unrenderedKeywords;
        if (std::ranges::find(keywords, keyword) == keywords.end())
            keywords.push_back(keyword);
    }

    ObjOutline outline_;
    size_t number_ = 0; ///< of the line at hand
    std::vector<ObjCorner> face_;
    std::array<int64_t, kObjDataCount> largestIndex_{};
    std::string material_;
    bool materialChanged_ = false;
    std::map<std::string, uint32_t> materialIndex_;
    uint32_t smoothingGroup_ = 0;
    std::map<std::string, uint32_t> groupIndex_;
};

} // namespace

ObjOutline outlineOfObj(std::string_view text, const OnProgress& onProgress) {
    return OutlineReader().read(text, onProgress);
}

} // namespace calotype
