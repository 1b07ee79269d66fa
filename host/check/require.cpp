#include "check/require.h"

#include <cmath>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "base/number_text.h"

namespace calotype {
namespace {

/// Larger than the tolerance of 1e-4 within which readers accept transforms as rigid.
constexpr double kTolerance = 1e-3;

} // namespace

void require(const Range& range, double number, const std::string& where) {
    if (!range.contains(number))
        throw SceneError(where, "must be " + toText(range) + ", not " + shortNumber(number));
}

void require(const Range& range, const glm::dvec3& numbers, const std::string& where) {
    for (int i = 0; i < 3; ++i)
        require(range, numbers[i], where + "/" + std::to_string(i));
}

void require(const ranges::WholeRange& range, uint32_t number, const std::string& where) {
    if (!range.contains(number)) {
        throw SceneError(where, "must be a whole number from " + std::to_string(range.low) +
                                    " to " + std::to_string(range.high) + ", not " +
                                    std::to_string(number));
    }
}

void requireOrthonormal(const glm::dmat3& axes, const std::string& where) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j <= i; ++j) {
            const double error = glm::dot(axes[i], axes[j]) - (i == j ? 1.0 : 0.0);
            if (!(std::abs(error) <= kTolerance)) { // also for NaN
                throw SceneError(where, "must be a rotation: three directions of length 1 at right "
                                        "angles");
            }
        }
    }
}

} // namespace calotype
