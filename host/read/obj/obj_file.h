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
    /// `material` is an index into `materialNames` or kNoMaterial. Faces one of whose normals is
    /// zero, not finite or missing have Mesh::kNoNormal in all corners; those one of whose texture
    /// coordinates is missing, Mesh::kNoUv.
    std::vector<Mesh::Triangle> triangles;
    std::vector<std::string> materialNames; ///< those that faces use
    std::vector<size_t> materialLines;      ///< of the first face that uses each
    std::vector<std::string> libraries;     ///< what follows each "mtllib"
    bool hasFacesWithoutMaterial = false;
    uint64_t crossingPolygons = 0; ///< cut into triangles that may overlap
};

/// Parses the text of the OBJ file at `path` (the name for messages). Throws SceneError at
/// "PATH:LINE" for what checkObj refuses, and at "PATH" where there is no polygon at all.
ObjFile parseObj(std::string_view text, const std::string& path);

} // namespace calotype
