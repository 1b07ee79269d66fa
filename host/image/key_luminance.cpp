#include "image/key_luminance.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "math/luminance.h"

namespace calotype {
namespace {

constexpr uint32_t kBlock = 16; ///< pixels
constexpr double kAlmostBlack = 1e-6;

/// Pixels that are not finite count as black.
double meanLuminanceOfBlock(const Image& picture, uint32_t left, uint32_t top) {
    const uint32_t right = std::min(left + kBlock, picture.width);
    const uint32_t bottom = std::min(top + kBlock, picture.height);
    double sum = 0.0;
    for (uint32_t y = top; y < bottom; ++y)
        for (uint32_t x = left; x < right; ++x)
            if (const double light = luminance(glm::dvec3(picture.at(x, y))); std::isfinite(light))
                sum += light;
    return sum / static_cast<double>((right - left) * (bottom - top));
}

} // namespace

double keyLuminance(const Image& picture) {
    std::vector<double> means;
    for (uint32_t top = 0; top < picture.height; top += kBlock)
        for (uint32_t left = 0; left < picture.width; left += kBlock)
            if (const double mean = meanLuminanceOfBlock(picture, left, top); mean > 0.0)
                means.push_back(mean);
    if (means.empty())
        return 0.0;
    std::ranges::nth_element(means, means.begin() + static_cast<ptrdiff_t>(means.size() / 2));
    const double darkest = kAlmostBlack * means[means.size() / 2];
    double logarithms = 0.0;
    uint32_t blocks = 0;
    for (const double mean : means)
        if (mean > darkest) {
            logarithms += std::log(mean);
            ++blocks;
        }
    return std::exp(logarithms / blocks);
}

} // namespace calotype
