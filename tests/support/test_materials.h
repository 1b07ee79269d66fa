#pragma once

#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "scene/scene.h"
#include "support/kernels/test_structs.h"

namespace calotype::test {

struct TestMaterial {
    std::string name;
    Material material;
    bool conservesEnergy = true; ///< as the scene format says
    /// Scale of the tangent of the half vector's angle on which the lobe varies.
    double lobeWidth = 1.0;
};

/// Every opaque model over a grid of its parameters.
std::vector<TestMaterial> testMaterials();

/// The event of seeing the material from wo, in the shading frame (z up, no normal but one).
shared::TestScattering scatteringOn(const Material& material, const glm::dvec3& wo);

/// Unit vector at an angle with that cosine to z, turned about z.
glm::dvec3 directionAt(double cosTheta, double phi);

} // namespace calotype::test
