#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "denoise/denoiser.h"
#include "image/denoiser_features.h"

namespace calotype {

/// What the statistical denoiser knows of a pixel's colour (docs/models.md, "The statistical
/// denoiser"). Its patch is the pixel and those beside it with the same features.
struct PixelStatistics {
    glm::dvec3 color{};
    glm::dvec3 variance{};      ///< the greater of its own and the mean of its patch
    glm::dvec3 patchColor{};    ///< mean of the patch
    glm::dvec3 patchVariance{}; ///< of that mean
};

/// Of all pixels, row by row. `threads` >= 1.
std::vector<PixelStatistics> pixelStatistics(const NoisyImage& noisy,
                                             const DenoiserFeatures& features, uint32_t threads);

/// The share that a pixel's weight keeps where the features differ, in [0, 1].
double featureWeight(const DenoiserFeatures& features, size_t a, size_t b);

/// The most that two means of so many replicas of the same pixel differ, in standard errors of the
/// difference, with a probability of 99 %: the quantile 0.995 of Student's distribution. `replicas`
/// is from 2 to shared::kReplicas.
double differenceBound(size_t replicas);

} // namespace calotype
