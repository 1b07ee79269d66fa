#include "read/obj/outline.h"

#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <optional>

#include "base/error.h"
#include "base/names.h"
#include "base/text_cursor.h"
#include "read/obj/lines.h"
#include "read/obj/tinyobj_text.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

/// Kinds of vertex data, in the order of a corner's fields.
enum Kind { kPosition, kTexcoord, kNormal, kKindCount };

constexpr std::array<const char*, kKindCount> kKindNames = {"position", "texture coordinate",
                                                            "normal"};
constexpr std::array<const char*, kKindCount> kKeywords = {"v", "vt", "vn"};
constexpr std::array<int, kKindCount> kFewestNumbers = {3, 1, 3};
/// Further numbers (weights, colours) are not used, but they must still be numbers.
constexpr std::array<int, kKindCount> kUsedNumbers = {3, 2, 3};

/// The vertex data that faces use, by kind and index.
using Usage = std::array<std::vector<bool>, kKindCount>;

/// One pass over the text. The first pass accepts bad numbers. If it found some, a second pass
/// collects what faces use, and a third reports bad numbers among that.
class ObjPass {
public:
    ObjPass(const std::string& path, Usage* collected, const Usage* relevant)
        : path_(path), collected_(collected), relevant_(relevant) {}

    void run(std::string_view text) {
        forEachObjLine(text, [this](size_t number, std::string_view line) {
            number_ = number;
            check(line);
        });
        for (int kind = 0; kind < kKindCount; ++kind) {
            if (largestIndex_[kind] > static_cast<int64_t>(counts_[kind])) {
                number_ = largestLine_[kind];
                fail(std::string(kKindNames[kind]) + " " + std::to_string(largestIndex_[kind]) +
                     " does not exist; the file has " + std::to_string(counts_[kind]));
            }
        }
        outline_.positions = counts_[kPosition];
        outline_.normals = counts_[kNormal];
        outline_.uvs = counts_[kTexcoord];
    }

    bool foundBadNumbers() const { return foundBadNumbers_; }
    const std::array<size_t, kKindCount>& counts() const { return counts_; }
    ObjOutline takeOutline() { return std::move(outline_); }

private:
    [[noreturn]] void fail(const std::string& message) const {
        throw SceneError(path_ + ":" + std::to_string(number_), message);
    }

    void check(std::string_view line) {
        if (line.empty() || line.front() == '#')
            return;
        TextCursor cursor(line);
        const std::string_view keyword = cursor.word();
        if (keyword == "v") {
            checkVertex(kPosition, cursor);
        } else if (keyword == "vt") {
            checkVertex(kTexcoord, cursor);
        } else if (keyword == "vn") {
            checkVertex(kNormal, cursor);
        } else if (keyword == "f") {
            checkFace(cursor);
        } else if (keyword == "usemtl") {
            material_ = trimmed(cursor.rest());
            materialChanged_ = true;
        } else if (keyword == "mtllib") {
            outline_.libraries.emplace_back(trimmed(cursor.rest()));
        }
    }

    void checkVertex(Kind kind, TextCursor& cursor) {
        if (cursor.atEnd())
            fail(std::string("\"") + kKeywords[kind] + "\" lacks its coordinates");
        ++counts_[kind];
        int numbers = 0;
        bool finite = true;
        bool inRange = true;
        while (!cursor.atEnd()) {
            const std::string_view word = cursor.word();
            const std::optional<double> value = parseNumber(word);
            outline_.needsRewriting =
                outline_.needsRewriting || !value || !tinyobjReadsNumber(word);
            if (!value)
                return complain(kind, [&] { return inQuotes(word) + " is not a number"; });
            if (numbers < kUsedNumbers[kind]) {
                finite = finite && std::isfinite(*value);
                inRange =
                    inRange && (kind != kTexcoord || ranges::kTextureCoordinate.contains(*value));
            }
            ++numbers;
        }
        if (numbers < kFewestNumbers[kind]) {
            return complain(kind, [&] {
                return std::string("a ") + kKindNames[kind] + " needs " +
                       std::to_string(kFewestNumbers[kind]) + " numbers, not " +
                       std::to_string(numbers);
            });
        }
        if (!finite && kind == kNormal) {
            outline_.nonFiniteNormals.push_back(counts_[kind] - 1);
        } else if (!finite) {
            complain(kind,
                     [&] { return std::string("this ") + kKindNames[kind] + " is not finite"; });
        } else if (!inRange) {
            complain(kind, [] {
                return "a texture coordinate must be " + toText(ranges::kTextureCoordinate);
            });
        }
    }

    /// `describe` makes the message only if needed, because that is slow.
    template <typename Describe>
    void complain(Kind kind, Describe&& describe) {
        foundBadNumbers_ = true;
        if (relevant_ != nullptr && (*relevant_)[kind][counts_[kind] - 1])
            fail(describe());
    }

    void checkFace(TextCursor& cursor) {
        size_t corners = 0;
        for (; !cursor.atEnd(); ++corners)
            checkCorner(cursor.word());
        if (corners < 3)
            fail("a face needs at least 3 corners, not " + std::to_string(corners));
        outline_.needsRewriting = outline_.needsRewriting || !cursor.rest().empty();
        noteMaterial();
        ++outline_.polygons;
        outline_.corners += corners;
    }

    /// "p", "p/t", "p/t/n" or "p//n"; the fields after the first may be empty.
    void checkCorner(std::string_view word) {
        const char* next = word.data();
        const char* const end = next + word.size();
        for (int field = 0; field < kKindCount; ++field) {
            int64_t index = 0;
            const auto [stop, error] = std::from_chars(next, end, index);
            if (stop != next)
                checkIndex(Kind(field), error == std::errc() ? index : INT64_MAX, word);
            else if (field == 0)
                break;
            next = stop;
            if (next == end) {
                outline_.needsRewriting = outline_.needsRewriting || word.back() == '/';
                return;
            }
            if (*next != '/')
                break;
            ++next;
        }
        fail("the corner " + inQuotes(word) +
             " is malformed; it should read like 1, 1/2, 1//3 or 1/2/3");
    }

    void checkIndex(Kind kind, int64_t index, std::string_view word) {
        const auto count = static_cast<int64_t>(counts_[kind]);
        if (index == 0)
            fail("the corner " + inQuotes(word) + " has the index 0, but indices count from 1");
        if (index < -count) {
            fail("the corner " + inQuotes(word) + " counts back beyond the first " +
                 kKindNames[kind] + " (there are " + std::to_string(count) + " so far)");
        }
        if (index > largestIndex_[kind]) {
            largestIndex_[kind] = index;
            largestLine_[kind] = number_;
        }
        if (collected_ != nullptr)
            (*collected_)[kind][static_cast<size_t>(index > 0 ? index - 1 : count + index)] = true;
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

    const std::string& path_;
    Usage* collected_;
    const Usage* relevant_;

    ObjOutline outline_;
    size_t number_ = 0; ///< of the line at hand
    std::array<size_t, kKindCount> counts_{};
    std::array<int64_t, kKindCount> largestIndex_{};
    std::array<size_t, kKindCount> largestLine_{};
    bool foundBadNumbers_ = false;
    std::string material_;
    bool materialChanged_ = false;
    std::map<std::string, uint32_t> materialIndex_;
};

} // namespace

ObjOutline checkObj(std::string_view text, const std::string& path) {
    ObjPass first(path, nullptr, nullptr);
    first.run(text);
    if (first.foundBadNumbers()) {
        Usage used;
        for (int kind = 0; kind < kKindCount; ++kind)
            used[kind].resize(first.counts()[kind]);
        ObjPass(path, &used, nullptr).run(text);
        ObjPass(path, nullptr, &used).run(text);
    }
    return first.takeOutline();
}

} // namespace calotype
