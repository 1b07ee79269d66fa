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

/// p_target = rigid(scale * p_source), `scale` > 0. A mirror is in the rotation's determinant.
struct SimilarityTransform {
    double scale = 1.0;
    RigidTransform rigid;
};

/// Whether `m` flattens space: the volume spanned by its normalised columns is below 1e-12, a
/// column is zero, or one is 1e100 times as long as another. Otherwise any finite size is fine.
bool isSingular(const glm::dmat3& m);

/// Whether `m` turns left hands into right ones. `m` is not singular.
bool isMirroring(const glm::dmat3& m);

/// The matrix that takes normals where `m` takes points, up to a positive factor: the inverse
/// transpose. `m` is not singular.
glm::dmat3 normalMatrix(const glm::dmat3& m);

/// The transform as rotation (or mirrored rotation), translation and uniform scale; nullopt where
/// lengths are scaled differently by more than 1e-5 relatively, which allows for typed digits. The
/// rotation is then the orthogonal matrix nearest to the given one.
std::optional<SimilarityTransform> asSimilarity(const AffineTransform& transform);

} // namespace calotype
