#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace calotype {

/// Triangulates polygons in space. Cuts quads along a diagonal, and others by ear clipping in the
/// coordinate plane nearest to the polygon (by its Newell normal). Reuses its memory for the next
/// polygon.
class Triangulator {
public:
    using Triangle = std::array<uint32_t, 3>;

    /// Exactly n - 2 triangles of corner indices, wound like the polygon, for n >= 3 corners; a
    /// convex polygon becomes the fan from its first corner. The triangles cover a flat, simple
    /// polygon exactly. If the polygon crosses itself, is far from flat, or is too irregular to cut
    /// in bounded time, all corners are used but triangles may overlap: see `sound`.
    std::span<const Triangle> triangulate(std::span<const glm::dvec3> polygon);

    /// Whether the last polygon was covered exactly. Always true for quads, even folded ones, which
    /// have no better cut.
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

    std::vector<glm::dvec3> local_; ///< the polygon from its first corner, scaled to about one
    std::vector<Corner> corners_;
    std::vector<uint32_t> reflex_; ///< corners that may be inside an ear; not all are still reflex
    std::vector<Triangle> triangles_;
    size_t testsLeft_ = 0;
    bool sound_ = true;
};

} // namespace calotype
