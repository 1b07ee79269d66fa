#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "read/obj/occurrences.h"
#include "read/obj/outline.h"

namespace calotype {

/// Polygons that are left out or lose data, by the kind of the data.
struct FaceFaults {
    std::array<Occurrences, kObjDataCount> missing;    ///< the data does not exist
    std::array<Occurrences, kObjDataCount> unusable;   ///< it is out of range
    std::array<Occurrences, kObjDataCount> unreadable; ///< it is in ObjOutline::unreadable
    std::array<Occurrences, kObjDataCount> partial;    ///< only some corners name some
    /// About the first unreadable data: "line 7: "x" is not a number".
    std::array<std::string, kObjDataCount> firstUnreadable;
};

/// Finds these polygons in the text that `outline` describes.
FaceFaults checkFaces(std::string_view text, const ObjOutline& outline,
                      const OnProgress& onProgress = {});

} // namespace calotype
