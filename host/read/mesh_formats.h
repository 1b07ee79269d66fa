#pragma once

#include <string>
#include <string_view>

#include "read/obj/obj_file.h"

namespace calotype {

/// One file format for meshes, which scene files may name.
struct MeshFormat {
    std::string_view extension; ///< in lower case, such as ".obj"
    /// Parses the text of the file at `path` (the name for messages). Throws SceneError with the
    /// place of the first mistake.
    ObjFile (*parse)(std::string_view text, const std::string& path, const OnProgress& onProgress);
};

/// The format of the file with that name, by its extension; OBJ for any other extension. A new
/// format needs a folder in read/ and a row in mesh_formats.cpp.
const MeshFormat& meshFormatOf(const std::string& path);

/// Throws SceneError at `path`, with the kind, for a text that is known to be of another kind than
/// a mesh that can be read, such as "a PLY mesh".
void refuseOtherKinds(std::string_view text, const std::string& path);

} // namespace calotype
