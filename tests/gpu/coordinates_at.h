#pragma once

#include <vector>

#include <glm/geometric.hpp>

#include "kernels/coordinates.spv.h"
#include "render/scene_buffers.h"
#include "support/device_numbers.h"
#include "support/gpu_test.h"
#include "support/primitive_scene.h"

/// Texture coordinates at hits, and the directions in which they grow, as the kernels find them.
namespace calotype::test {

inline std::vector<shared::TestCoordinates>
coordinatesAt(const PrimitiveScene& scene, const std::vector<shared::TestRay>& rays) {
    const SceneBuffers buffers(testDevice(), scene.packed());
    return runKernel<shared::TestCoordinates>(kCoordinatesSpirv, rays, buffers.bindings(),
                                              kTestInputBinding);
}

inline glm::dvec3 unit(const glm::vec3& v) { return glm::normalize(glm::dvec3(v)); }

/// That texture coordinates do along a direction of the surface what dpdu promises of u: it grows,
/// the other one stays. `slope` is the derivative of (u, v) per unit of length along a direction.
template <typename Slope>
void expectGrowth(const shared::TestCoordinates& at, const Slope& slope, double tolerance) {
    const glm::dvec2 alongU = slope(unit(at.dpdu));
    const glm::dvec2 alongV = slope(unit(at.dpdv));
    EXPECT_GT(alongU.x, 0.0);
    EXPECT_GT(alongV.y, 0.0);
    EXPECT_NEAR(alongU.y / alongV.y, 0.0, tolerance);
    EXPECT_NEAR(alongV.x / alongU.x, 0.0, tolerance);
}

} // namespace calotype::test
