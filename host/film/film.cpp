#include "film/film.h"

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "shared/limits.h"

namespace calotype {
namespace {

using gpu::kSamplesPerBlock;

bool isFinite(const glm::vec4& sum) {
    return std::isfinite(sum.r) && std::isfinite(sum.g) && std::isfinite(sum.b);
}

/// Whether a finite sum can enter the film.
bool isInRange(const glm::vec4& sum, double unit) {
    const float largest = std::max({std::abs(sum.r), std::abs(sum.g), std::abs(sum.b)});
    return double{largest} < kFixedPointTermLimit * unit;
}

} // namespace

double filmUnit(double maxRadiance) {
    CALOTYPE_CHECK_LE(0.0, maxRadiance);
    CALOTYPE_CHECK_EQ(std::isfinite(maxRadiance), true);
    if (maxRadiance == 0.0)
        return 1.0;
    int exponent = 0;
    const bool isPowerOfTwo = std::frexp(maxRadiance, &exponent) == 0.5;
    return std::ldexp(1.0, std::clamp(isPowerOfTwo ? exponent - 1 : exponent, -126, 127));
}

Film::Film(uint32_t width, uint32_t height, double unit)
    : width_(width), height_(height), unit_(unit), sums_(size_t{width} * height) {
    CALOTYPE_CHECK_LT(0u, sums_.size());
    CALOTYPE_CHECK_EQ(unit, filmUnit(unit));
}

void Film::addBlock(std::span<const glm::vec4> blockSums) {
    CALOTYPE_CHECK_EQ(blockSums.size(), sums_.size());
    CALOTYPE_CHECK_LT(blocks_, kMaxBlocks);
    const double unitsPerRadiance = 1.0 / unit_;
    for (size_t i = 0; i < blockSums.size(); ++i) {
        const glm::vec4& block = blockSums[i];
        CALOTYPE_CHECK_EQ(block.w, float{kSamplesPerBlock});
        if (!isFinite(block)) {
            ++nonFinitePixels_;
        } else if (!isInRange(block, unit_)) {
            ++overflowedPixels_;
        } else {
            sums_[i].r += toFixedPoint(block.r * unitsPerRadiance);
            sums_[i].g += toFixedPoint(block.g * unitsPerRadiance);
            sums_[i].b += toFixedPoint(block.b * unitsPerRadiance);
        }
    }
    ++blocks_;
}

Image Film::picture(std::span<const glm::vec4> partialBlock) const {
    if (!partialBlock.empty())
        CALOTYPE_CHECK_EQ(partialBlock.size(), sums_.size());
    Image image(width_, height_);
    for (size_t i = 0; i < sums_.size(); ++i) {
        glm::dvec3 sum(fromFixedPoint(sums_[i].r), fromFixedPoint(sums_[i].g),
                       fromFixedPoint(sums_[i].b));
        sum *= unit_;
        auto samples = static_cast<double>(samplesPerPixel());
        if (!partialBlock.empty()) {
            const glm::vec4& partial = partialBlock[i];
            CALOTYPE_CHECK_LE(0.0f, partial.w);
            samples += partial.w;
            if (isFinite(partial) && isInRange(partial, unit_))
                sum += glm::dvec3(partial);
        }
        image.pixels[i] = samples > 0.0 ? glm::vec3(sum / samples) : glm::vec3(0.0f);
    }
    return image;
}

uint64_t Film::samplesPerPixel() const { return blocks_ * kSamplesPerBlock; }

} // namespace calotype
