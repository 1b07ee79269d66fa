#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "base/progress.h"
#include "read/obj/obj_notes.h"
#include "read/obj/outline.h"
#include "scene/scene.h"

namespace calotype {

/// A Wavefront OBJ file, triangulated, in its own coordinates.
struct ObjFile {
    static constexpr uint32_t kNoMaterial = ObjOutline::kNoMaterial;

    std::vector<glm::dvec3> positions;
    std::vector<glm::dvec3> normals;
    std::vector<glm::dvec2> uvs;
    /// `material` is an index into `materialNames` or kNoMaterial. If one of a face's normals is
    /// zero, not finite or missing, all its corners have Mesh::kNoNormal; if one of its texture
    /// coordinates is not usable or missing, all have Mesh::kNoUv. Faces of a smoothing group that
    /// are given no normals have those that smoothNormals makes.
    std::vector<Mesh::Triangle> triangles;
    std::vector<std::string> materialNames; ///< those that faces use
    std::vector<size_t> materialLines;      ///< of the first face that uses each
    std::vector<std::string> libraries;     ///< what follows each "mtllib"
    bool hasFacesWithoutMaterial = false;
    uint64_t crossingPolygons = 0; ///< polygons whose triangles may overlap
    std::vector<ObjNote> notes;    ///< what was left out, or is not as written
};

/// Parses the text of the OBJ file at `path` (the name for messages). Faces that cannot be rendered
/// are left out, see docs/obj.md. Throws SceneError at `path` if there is no polygon at all or all
/// were left out.
ObjFile parseObj(std::string_view text, const std::string& path, const OnProgress& onProgress = {});

} // namespace calotype
