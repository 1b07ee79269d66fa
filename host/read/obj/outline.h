#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace calotype {

/// What an OBJ file holds, short of its numbers.
struct ObjOutline {
    static constexpr uint32_t kNoMaterial = ~0u;

    /// From polygon `firstPolygon` on, faces use `materialNames[material]`, or none.
    struct MaterialRun {
        size_t firstPolygon;
        uint32_t material;
    };
    size_t positions = 0;
    size_t normals = 0;
    size_t uvs = 0;
    size_t polygons = 0;
    size_t corners = 0;
    std::vector<std::string> materialNames; ///< those that faces use, in the order of first use
    std::vector<size_t> materialLines;      ///< of the first face that uses each
    std::vector<MaterialRun> materialRuns;
    std::vector<std::string> libraries;   ///< what follows each "mtllib"
    std::vector<size_t> nonFiniteNormals; ///< indices of normals with a NaN or an infinity
    /// Whether tinyobjloader would misread faces, for comments after them or empty last fields, or
    /// numbers of vertices.
    bool needsRewriting = false;
};

/// Finds what tinyobjloader passes over in silence. Throws SceneError at "PATH:LINE" for faces
/// with fewer than three corners or malformed ones, for indices of 0 or out of range, and for
/// vertices that a face uses but whose numbers are missing, garbage, (but for normals) not finite
/// or (of texture coordinates) outside ranges::kTextureCoordinate.
ObjOutline checkObj(std::string_view text, const std::string& path);

} // namespace calotype
