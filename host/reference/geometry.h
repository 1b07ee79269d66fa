#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "reference/ray.h"
#include "reference/surface.h"
#include "reference/tree.h"
#include "scene/scene.h"

namespace calotype::reference {

/// Primitives are numbered in the order of the scene file: each quadric is one, each mesh has one
/// for each triangle.
struct Hit {
    double t;
    uint32_t primitive;
};

struct PrimitiveName {
    uint32_t shape;    ///< index into Scene::shapes
    uint32_t triangle; ///< index into the mesh's triangles; 0 for a quadric
};

/// All shapes of a scene, for ray intersection. Can be used by several threads at once.
class Geometry {
public:
    /// Keeps a reference to the scene.
    explicit Geometry(const Scene& scene);
    explicit Geometry(const Scene&&) = delete;

    size_t primitiveCount() const { return names_.size(); }
    PrimitiveName primitive(uint32_t number) const { return names_[number]; }
    uint32_t materialOf(uint32_t number) const;
    /// Square metres, of one side.
    double areaOf(uint32_t number) const;

    /// The first hit with t in (0, ray.length); among several at the same t, that of the lowest
    /// number. A ray that leaves a surface from `offsetFrom` does not hit it again there.
    std::optional<Hit> closest(const Ray& ray) const;

    /// The surface at a hit of that ray.
    Surface surface(const Hit& hit, const Ray& ray) const;

    /// Texture coordinates of a primitive at a point that is on it, up to rounding.
    glm::dvec2 uvAt(uint32_t number, const glm::dvec3& point) const;

private:
    const Scene& scene_;
    std::vector<PrimitiveName> names_;
    Tree tree_;
};

} // namespace calotype::reference
