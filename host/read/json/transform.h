#pragma once

#include "math/affine_transform.h"
#include "read/json/object.h"

namespace calotype {

/// The key "transform" of shapes and lights.
JsonKey transformKey();

/// worldFromObject of a shape's or light's "transform" (the identity if it has none): translate,
/// rotate (degrees) and scale as T Rz Ry Rx S, or "matrix", 16 numbers, row-major. Throws
/// SceneError for a singular transform and for a matrix that is not affine.
AffineTransform readTransform(const JsonObject& shape);

/// The same for quadrics and disks, which accept rotation, translation and uniform scale only.
SimilarityTransform readSimilarity(const JsonObject& shape);

/// 16 numbers, row-major, the last row 0 0 0 1.
AffineTransform readMatrix(const JsonValue& value);

} // namespace calotype
