#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace calotype {

/// The structure of an OBJ file, without its numbers.
struct ObjOutline {
    static constexpr uint32_t kNoMaterial = ~0u;

    /// From polygon `firstPolygon` on, faces use `materialNames[material]`, or no material.
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
    /// Whether tinyobjloader would misread the file, because of comments after faces, empty last
    /// fields, or some numbers of vertices.
    bool needsRewriting = false;
};

/// Finds errors that tinyobjloader ignores. Throws SceneError at "PATH:LINE" for faces with fewer
/// than three corners or malformed ones, for indices of 0 or out of range, and for vertices that a
/// face uses but whose numbers are missing, invalid, (except normals) not finite or (texture
/// coordinates) outside ranges::kTextureCoordinate.
ObjOutline checkObj(std::string_view text, const std::string& path);

} // namespace calotype
