#include "math/affine_transform.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace calotype {
namespace {

constexpr double kSingularVolume = 1e-12;
/// Ratio of the columns' lengths. The square of its inverse, a determinant, is a normal number.
constexpr double kMostAnisotropy = 1e100;
constexpr double kSimilarityTolerance = 1e-5;

double largestEntry(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

double largestEntry(const glm::dmat3& m) {
    return std::max({largestEntry(m[0]), largestEntry(m[1]), largestEntry(m[2])});
}

/// Each column divided by its length, without overflow. No column is zero.
glm::dmat3 normalizedColumns(const glm::dmat3& m) {
    glm::dmat3 result;
    for (int column = 0; column < 3; ++column)
        result[column] = glm::normalize(m[column] / largestEntry(m[column]));
    return result;
}

/// Newton's iteration for the orthogonal factor of the polar decomposition (Higham 1986). It
/// converges quadratically, and `m` is already within 1e-5 of the result.
glm::dmat3 nearestOrthogonal(glm::dmat3 m) {
    for (int i = 0; i < 4; ++i)
        m = 0.5 * (m + glm::transpose(glm::inverse(m)));
    return m;
}

} // namespace

bool isSingular(const glm::dmat3& m) {
    const double largest = largestEntry(m);
    for (int column = 0; column < 3; ++column)
        if (!(largestEntry(m[column]) / largest > 1.0 / kMostAnisotropy))
            return true;
    return std::abs(glm::determinant(normalizedColumns(m))) < kSingularVolume;
}

bool isMirroring(const glm::dmat3& m) { return glm::determinant(normalizedColumns(m)) < 0.0; }

glm::dmat3 normalMatrix(const glm::dmat3& m) {
    return glm::transpose(glm::inverse(m / largestEntry(m)));
}

std::optional<SimilarityTransform> asSimilarity(const AffineTransform& transform) {
    const double largest = largestEntry(transform.linear);
    const glm::dmat3 unit = transform.linear / largest;
    const glm::dmat3 squares = glm::transpose(unit) * unit;
    const double meanSquare = (squares[0][0] + squares[1][1] + squares[2][2]) / 3.0;
    for (int column = 0; column < 3; ++column) {
        for (int row = 0; row < 3; ++row) {
            const double wanted = column == row ? 1.0 : 0.0;
            // Lengths are squared, so twice the tolerance.
            if (!(std::abs(squares[column][row] / meanSquare - wanted) <
                  2.0 * kSimilarityTolerance)) {
                return std::nullopt;
            }
        }
    }
    const double unitScale = std::sqrt(meanSquare);
    return SimilarityTransform{largest * unitScale,
                               {nearestOrthogonal(unit / unitScale), transform.translation}};
}

} // namespace calotype
