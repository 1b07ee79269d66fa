#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

namespace calotype {

/// Rz Ry Rx on column vectors, angles in degrees: about X first, then Y, then Z. Multiples of 90
/// degrees give exact zeros and ones.
glm::dmat3 rotationFromDegrees(const glm::dvec3& degrees);

/// A rotation that takes +Y to `direction` (unit length), the identity for +Y itself. Orthonormal
/// to rounding for every direction (Duff et al. 2017, "Building an Orthonormal Basis, Revisited").
glm::dmat3 rotationTakingYTo(const glm::dvec3& direction);

} // namespace calotype
