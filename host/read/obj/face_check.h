#pragma once

#include <array>
#include <string>
#include <string_view>

#include "base/progress.h"
#include "read/obj/occurrences.h"
#include "read/obj/outline.h"

namespace calotype {

/// Polygons whose corners name vertex data that does not exist or cannot be used, by kind.
struct FaceFaults {
    std::array<Occurrences, kObjDataCount> missing;
    std::array<Occurrences, kObjDataCount> unusable;
};

/// Finds these polygons in the text that `outline` describes. Throws SceneError at "PATH:LINE" of
/// vertex data that one of them uses but that is unreadable.
FaceFaults checkFaces(std::string_view text, const std::string& path, const ObjOutline& outline,
                      const OnProgress& onProgress = {});

} // namespace calotype
