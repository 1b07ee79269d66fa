#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace calotype {

/// Triangulates polygons in space. Quads are cut along a diagonal, all others by clipping ears in
/// the coordinate plane that the polygon (its Newell normal) is nearest to. Keeps its memory from
/// polygon to polygon.
class Triangulator {
public:
    using Triangle = std::array<uint32_t, 3>;

    /// Exactly n - 2 triangles of corner indices, wound like the polygon, for n >= 3 corners; a
    /// convex polygon becomes the fan from its first corner. The triangles cover a flat, simple
    /// polygon exactly. Of one that crosses itself or is far from flat, or that is too ragged to be
    /// cut in bounded time, all corners are kept but triangles may overlap: see `sound`.
    std::span<const Triangle> triangulate(std::span<const glm::dvec3> polygon);

    /// Whether the last polygon was covered exactly. Always true of quads, which have no better
    /// cut, even where they are folded.
    bool sound() const { return sound_; }

private:
    struct Corner {
        double x;
        double y;
        uint32_t previous;
        uint32_t next;
        bool reflex;
    };

    void moveToOrigin(std::span<const glm::dvec3> polygon);
    void cutQuad();
    void clipEars();
    void project();
    double turn(uint32_t corner) const;
    void updateReflex(uint32_t corner);
    bool isEar(uint32_t corner);
    uint32_t flattestCorner(uint32_t corner, uint32_t left) const;
    void clip(uint32_t corner);

    std::vector<glm::dvec3> local_; ///< the polygon from its first corner, of a size near one
    std::vector<Corner> corners_;
    std::vector<uint32_t> reflex_; ///< candidates that may lie in an ear; some no longer reflex
    std::vector<Triangle> triangles_;
    size_t testsLeft_ = 0;
    bool sound_ = true;
};

} // namespace calotype
