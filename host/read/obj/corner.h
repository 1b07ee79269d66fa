#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "base/text_cursor.h"

namespace calotype {

/// Kinds of vertex data, in the order of a corner's fields.
enum ObjData : uint8_t { kObjPosition, kObjTexcoord, kObjNormal, kObjDataCount };

/// One corner of a face: the indices as they are written, from 1, or negative if counted from the
/// end. No value for a field that is empty or missing; only the position is never so.
using ObjCorner = std::array<std::optional<int64_t>, kObjDataCount>;

/// Reads "p", "p/t", "p/t/n" or "p//n"; fields after the first may be empty. An index outside the
/// range of int64_t becomes its end. nullopt for anything else.
std::optional<ObjCorner> parseObjCorner(std::string_view word);

/// Reads the corners of a face up to the end or a comment; false if one of them cannot be read.
bool parseObjFace(TextCursor cursor, std::vector<ObjCorner>& corners);

/// Whether some of the corners, but not all, name data of this kind.
inline bool isPartial(std::span<const ObjCorner> corners, ObjData kind) {
    return std::ranges::any_of(corners, [&](const ObjCorner& corner) {
        return corner[kind].has_value() != corners.front()[kind].has_value();
    });
}

/// Instead of an index that is not given; equal to Mesh::kNoNormal and Mesh::kNoUv.
constexpr uint32_t kNoObjData = ~0u;
/// Instead of an index that is 0, or counts back beyond the first.
constexpr uint32_t kBadObjData = ~0u - 1;

/// The index from 0 of what a corner names, after `count` of its kind. It may not exist.
inline uint32_t resolveObjIndex(std::optional<int64_t> index, size_t count) {
    if (!index)
        return kNoObjData;
    const int64_t fromZero = *index > 0 ? *index - 1 : static_cast<int64_t>(count) + *index;
    return *index == 0 || fromZero < 0 || fromZero >= kBadObjData ? kBadObjData
                                                                  : static_cast<uint32_t>(fromZero);
}

} // namespace calotype
