#include "denoise/pixel_statistics.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "base/parallel_for.h"
#include "math/square.h"
#include "shared/denoise_structs.h"
#include "shared/limits.h"

namespace calotype {
namespace {

/// Of Student's distribution with 2, 4, ... degrees of freedom: those of two means of 2, 3, ...
/// replicas.
constexpr std::array kQuantiles = {9.925, 4.604, 3.707, 3.355, 3.169, 3.055, 2.977};
static_assert(kQuantiles.size() == shared::kReplicas - 1);

/// Half of the squared distance of two vectors, in standard deviations.
double halfSquare(const glm::vec3& a, const glm::vec3& b, double deviation) {
    const glm::dvec3 difference = (glm::dvec3(a) - glm::dvec3(b)) / deviation;
    return 0.5 * glm::dot(difference, difference);
}

PixelStatistics statisticsOf(const NoisyImage& noisy, const DenoiserFeatures& features, uint32_t x,
                             uint32_t y) {
    const uint32_t width = noisy.color.width;
    const size_t own = size_t{y} * width + x;
    double sum = 0.0;
    glm::dvec3 color(0.0);
    glm::dvec3 variance(0.0);
    glm::dvec3 varianceOfSum(0.0);
    for (uint32_t v = y - std::min(y, 1u); v < std::min(y + 2, noisy.color.height); ++v)
        for (uint32_t u = x - std::min(x, 1u); u < std::min(x + 2, width); ++u) {
            const size_t pixel = size_t{v} * width + u;
            const double weight = featureWeight(features, own, pixel);
            const glm::dvec3 error(noisy.standardError.pixels[pixel]);
            sum += weight;
            color += weight * glm::dvec3(noisy.color.pixels[pixel]);
            variance += weight * error * error;
            varianceOfSum += weight * weight * error * error;
        }
    const glm::dvec3 ownError(noisy.standardError.pixels[own]);
    return {glm::dvec3(noisy.color.pixels[own]), glm::max(ownError * ownError, variance / sum),
            color / sum, varianceOfSum / square(sum)};
}

} // namespace

double featureWeight(const DenoiserFeatures& features, size_t a, size_t b) {
    return std::exp(
        -halfSquare(features.albedo.pixels[a], features.albedo.pixels[b],
                    shared::kAlbedoDeviation) -
        halfSquare(features.normal.pixels[a], features.normal.pixels[b], shared::kNormalDeviation));
}

std::vector<PixelStatistics> pixelStatistics(const NoisyImage& noisy,
                                             const DenoiserFeatures& features, uint32_t threads) {
    for (const Image* image : {&noisy.standardError, &features.albedo, &features.normal}) {
        CALOTYPE_CHECK_EQ(image->width, noisy.color.width);
        CALOTYPE_CHECK_EQ(image->height, noisy.color.height);
    }
    std::vector<PixelStatistics> statistics(noisy.color.pixels.size());
    parallelFor(0, noisy.color.height, threads, [&](uint64_t row, uint32_t) {
        const auto y = static_cast<uint32_t>(row);
        for (uint32_t x = 0; x < noisy.color.width; ++x)
            statistics[row * noisy.color.width + x] = statisticsOf(noisy, features, x, y);
    });
    return statistics;
}

double differenceBound(size_t replicas) {
    CALOTYPE_CHECK_LE(size_t{2}, replicas);
    CALOTYPE_CHECK_LE(replicas, size_t{shared::kReplicas});
    return kQuantiles[replicas - 2];
}

} // namespace calotype
