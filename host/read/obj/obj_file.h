#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

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
    /// coordinates is missing, all have Mesh::kNoUv.
    std::vector<Mesh::Triangle> triangles;
    std::vector<std::string> materialNames; ///< those that faces use
    std::vector<size_t> materialLines;      ///< of the first face that uses each
    std::vector<std::string> libraries;     ///< what follows each "mtllib"
    bool hasFacesWithoutMaterial = false;
    uint64_t crossingPolygons = 0; ///< polygons whose triangles may overlap
};

/// Parses the text of the OBJ file at `path` (the name for messages). Throws SceneError at
/// "PATH:LINE" like checkObj, and at "PATH" if there is no polygon at all.
ObjFile parseObj(std::string_view text, const std::string& path);

} // namespace calotype
