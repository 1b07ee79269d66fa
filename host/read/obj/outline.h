#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "base/progress.h"
#include "read/obj/corner.h"
#include "read/obj/occurrences.h"

namespace calotype {

/// The structure of an OBJ file, without its numbers, and what is wrong with it.
struct ObjOutline {
    static constexpr uint32_t kNoMaterial = ~0u;

    /// From polygon `firstPolygon` on, faces use `materialNames[material]`, or no material.
    struct MaterialRun {
        size_t firstPolygon;
        uint32_t material;
    };
    /// From polygon `firstPolygon` on, faces belong to this smoothing group; 0 is none.
    struct SmoothingRun {
        size_t firstPolygon;
        uint32_t group;
    };
    /// Vertex data with a number that is missing or cannot be read.
    struct Unreadable {
        size_t line;
        std::string message;
    };
    enum class DataState : uint8_t { Usable, Missing, Unusable };

    std::array<size_t, kObjDataCount> counts{}; ///< of vertex data, by kind
    size_t polygons = 0;                        ///< of three corners or more
    size_t corners = 0;                         ///< of these polygons
    std::vector<std::string> materialNames;     ///< those that faces use, by first use
    std::vector<size_t> materialLines;          ///< of the first face that uses each
    std::vector<MaterialRun> materialRuns;
    std::vector<SmoothingRun> smoothingRuns;
    std::vector<std::string> libraries; ///< what follows each "mtllib"

    /// By kind and index: whether numbers are unreadable or not finite, a normal is zero, or a
    /// texture coordinate is outside ranges::kTextureCoordinate. The rest, beyond the end, is
    /// usable.
    std::array<std::vector<bool>, kObjDataCount> isUnusable;
    /// By kind and index.
    std::array<std::map<size_t, Unreadable>, kObjDataCount> unreadable;
    Occurrences smallFaces;      ///< of fewer than three corners; they are not counted as polygons
    Occurrences unreadableFaces; ///< with a corner that cannot be read; not counted either
    Occurrences coloredLines;    ///< with the colour of a vertex
    Occurrences unrendered;      ///< statements that would show something but are not rendered
    std::vector<std::string> unrenderedKeywords; ///< of these, each once
    bool hasBadIndices = false;                  ///< of polygons: 0 or out of range
    bool hasPartialFaces = false;                ///< polygons for which isPartial is true

    /// Whether tinyobjloader would misread the file, because of comments after faces, empty last
    /// fields, faces that are left out, keywords in capitals, or some numbers.
    bool needsRewriting = false;

    /// Whether checkFaces may find something.
    bool needsFaceCheck() const {
        bool needs = hasBadIndices || hasPartialFaces;
        for (size_t kind = 0; kind < kObjDataCount; ++kind)
            needs = needs || !isUnusable[kind].empty();
        return needs;
    }

    /// Of what a polygon's corner names; `index` is from resolveObjIndex.
    DataState stateOf(ObjData kind, uint32_t index) const {
        if (index >= counts[kind])
            return DataState::Missing;
        const std::vector<bool>& unusable = isUnusable[kind];
        return index < unusable.size() && unusable[index] ? DataState::Unusable : DataState::Usable;
    }
};

/// Reads the structure of an OBJ.
ObjOutline outlineOfObj(std::string_view text, const OnProgress& onProgress = {});

} // namespace calotype
