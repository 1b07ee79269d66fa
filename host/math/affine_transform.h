#pragma once

#include <optional>

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include "math/rigid_transform.h"

namespace calotype {

/// p_target = linear * p_source + translation.
struct AffineTransform {
    glm::dmat3 linear{1.0};
    glm::dvec3 translation{0.0};

    glm::dvec3 point(const glm::dvec3& p) const { return linear * p + translation; }
    glm::dvec3 direction(const glm::dvec3& d) const { return linear * d; }
};

/// p_target = rigid(scale * p_source), `scale` > 0. A mirroring rotation has determinant -1.
struct SimilarityTransform {
    double scale = 1.0;
    RigidTransform rigid;
};

/// Whether `m` has no inverse: the volume spanned by its normalised columns is below 1e-12, a
/// column is zero, or one is 1e100 times as long as another. Any other finite size is fine.
bool isSingular(const glm::dmat3& m);

/// Whether `m` mirrors: its determinant is negative. `m` must not be singular.
bool isMirroring(const glm::dmat3& m);

/// The matrix that transforms normals if `m` transforms points, up to a positive factor: the
/// inverse transpose. `m` must not be singular.
glm::dmat3 normalMatrix(const glm::dmat3& m);

/// The transform as rotation (or mirrored rotation), translation and uniform scale. nullopt if the
/// scales of lengths differ by more than 1e-5 relatively; this tolerance allows for rounded input.
/// The rotation is the orthogonal matrix nearest to the given one.
std::optional<SimilarityTransform> asSimilarity(const AffineTransform& transform);

} // namespace calotype
