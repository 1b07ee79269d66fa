#pragma once

#include <string>
#include <vector>

#include "pack/gpu_scene.h"
#include "support/kernels/test_structs.h"
#include "support/oracle_line.h"

namespace calotype::test {

/// Primitives on the device, to be met one by one or, where `scene` has nodes of its own, by
/// traversal.
class PrimitiveScene {
public:
    explicit PrimitiveScene(GpuScene scene);

    static PrimitiveScene ofQuadrics(std::vector<shared::Quadric> quadrics);
    static PrimitiveScene ofTriangles(std::vector<shared::Triangle> triangles);

    const GpuScene& packed() const { return scene_; }

    /// crossPrimitive and interactionAt: each ray meets its own primitive only.
    std::vector<shared::TestHit> hits(const std::vector<shared::TestRay>& rays) const;

    struct Traversed {
        float t;
        uint32_t primitive;
        uint32_t iterations;
        uint32_t pad;
    };

    /// traceRay: each ray meets everything but its own primitive.
    std::vector<Traversed> traverse(const std::vector<shared::TestRay>& rays) const;

private:
    GpuScene scene_;
};

/// offsetFromSurface of each point.
std::vector<glm::vec3> offsetPoints(const std::vector<shared::TestOffset>& points);

/// A ray without end that starts at `origin`.
inline shared::TestRay testRay(const glm::dvec3& origin, const glm::dvec3& direction,
                               uint32_t primitive) {
    return {glm::vec3(origin), primitive, glm::vec3(direction), 1e19f, 0, 0, 0, 0};
}

/// The same ray for the oracle.
inline Line lineOf(const shared::TestRay& ray) { return {Vec3(ray.origin), Vec3(ray.direction)}; }

/// A ray, the quadric that it was aimed at and the answer, for messages.
std::string describe(const shared::Quadric& quadric, const shared::TestRay& ray, float t);

} // namespace calotype::test
