#include "denoise/statistical_denoiser.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

#include "base/parallel_for.h"
#include "denoise/pixel_statistics.h"
#include "math/square.h"
#include "shared/denoise_structs.h"

namespace calotype {
namespace {

/// The weights of the pixels of one picture for each other.
class PixelWeights {
public:
    PixelWeights(const NoisyImage& noisy, const DenoiserFeatures& features, uint32_t threads)
        : width_(noisy.color.width), height_(noisy.color.height), threads_(threads),
          features_(features), statistics_(pixelStatistics(noisy, features, threads)),
          squaredBound_(square(differenceBound(noisy.replicas))) {}

    const glm::dvec3& color(size_t pixel) const { return statistics_[pixel].color; }

    /// Calls take(pixel, other, weight) for each pixel and all others in its square, itself
    /// included, whose weight is not 0. Several threads call it, each for other pixels.
    template <typename Take>
    void forEach(const Take& take) const {
        parallelFor(0, height_, threads_, [&](uint64_t row, uint32_t) {
            for (uint32_t x = 0; x < width_; ++x)
                forEachAround(x, static_cast<uint32_t>(row), take);
        });
    }

private:
    template <typename Take>
    void forEachAround(uint32_t x, uint32_t y, const Take& take) const {
        constexpr uint32_t kRadius = shared::kDenoiserRadius;
        const size_t pixel = size_t{y} * width_ + x;
        for (uint32_t v = y - std::min(y, kRadius); v < std::min(y + kRadius + 1, height_); ++v)
            for (uint32_t u = x - std::min(x, kRadius); u < std::min(x + kRadius + 1, width_);
                 ++u) {
                const size_t other = size_t{v} * width_ + u;
                if (!isSimilar(statistics_[pixel], statistics_[other]))
                    continue;
                const double distance2 = square(double(u) - x) + square(double(v) - y);
                const double nearness =
                    std::exp(-0.5 * distance2 / square(shared::kDistanceDeviation));
                take(pixel, other, nearness * featureWeight(features_, pixel, other));
            }
    }

    /// Whether both differences are within the noise in every channel.
    bool isSimilar(const PixelStatistics& a, const PixelStatistics& b) const {
        return isWithinNoise(a.color - b.color, a.variance + b.variance) &&
               isWithinNoise(a.patchColor - b.patchColor, a.patchVariance + b.patchVariance);
    }

    bool isWithinNoise(const glm::dvec3& difference, const glm::dvec3& variance) const {
        return glm::all(glm::lessThanEqual(difference * difference, squaredBound_ * variance));
    }

    uint32_t width_;
    uint32_t height_;
    uint32_t threads_;
    const DenoiserFeatures& features_;
    std::vector<PixelStatistics> statistics_;
    double squaredBound_;
};

} // namespace

StatisticalDenoiser::StatisticalDenoiser(DenoiserFeatures features, uint32_t threads)
    : features_(std::move(features)), threads_(threads > 0 ? threads : allCores()) {}

Image StatisticalDenoiser::run(const NoisyImage& noisy) {
    const PixelWeights weights(noisy, features_, threads_);
    std::vector<double> sums(noisy.color.pixels.size());
    weights.forEach([&](size_t pixel, size_t, double weight) { sums[pixel] += weight; });
    // Both pixels of a pair divide by the same sum: what one takes of the other, the other takes
    // of it, so that the mean of the picture stays.
    std::vector<glm::dvec3> changes(sums.size());
    weights.forEach([&](size_t pixel, size_t other, double weight) {
        changes[pixel] += weight / std::max(sums[pixel], sums[other]) *
                          (weights.color(other) - weights.color(pixel));
    });
    Image image(noisy.color.width, noisy.color.height);
    for (size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = glm::vec3(weights.color(i) + changes[i]);
    return image;
}

} // namespace calotype
