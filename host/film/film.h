#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include <glm/vec4.hpp>

#include "film/fixed_point.h"
#include "image/image.h"

namespace calotype {

/// The unit of a film's sums: the least power of two at or above the scene's largest emitted
/// radiance, a finite number >= 0; kept within 2^-126 and 2^127, and 1 for a scene without light.
double filmUnit(double maxRadiance);

/// The samples of a picture so far, summed per pixel and channel in fixed point of 128 bits, of
/// which 64 lie below one `unit`. Films are therefore bit for bit the same whatever the order in
/// which their blocks came, and no sum stagnates.
///
/// Range: a sum of one block enters exactly from 2^-41 units up, and to within 2^-65 units below;
/// it stays below 2^40 units, and a film's sum below 2^63 units, so 2^23 blocks fit.
class Film {
public:
    static constexpr uint64_t kMaxBlocks = uint64_t{1} << 23;

    struct Sum {
        FixedPoint r = 0;
        FixedPoint g = 0;
        FixedPoint b = 0;

        bool operator==(const Sum&) const = default;
    };

    /// A black film of width * height > 0 pixels; `unit` is a power of two, as filmUnit gives it.
    Film(uint32_t width, uint32_t height, double unit);

    /// Adds one whole block: per pixel, row by row, the sum of r, g, b over gpu::kSamplesPerBlock
    /// samples, and that number in w. A pixel whose sum is not finite, or from 2^40 units up, adds
    /// nothing, stays in the count of samples, and is reported below.
    void addBlock(std::span<const glm::vec4> blockSums);

    /// Mean radiance per pixel; black where there is no sample. `partialBlock`, if not empty, is
    /// like a block, but with any number of samples in each pixel: it shows in the picture only.
    Image picture(std::span<const glm::vec4> partialBlock = {}) const;

    uint32_t width() const { return width_; }
    uint32_t height() const { return height_; }
    double unit() const { return unit_; }
    uint64_t blocks() const { return blocks_; }
    uint64_t samplesPerPixel() const;

    /// In units, row by row from the top left pixel.
    std::span<const Sum> sums() const { return sums_; }

    /// Pixels of added blocks that were left out, once for each block.
    uint64_t nonFinitePixels() const { return nonFinitePixels_; }
    uint64_t overflowedPixels() const { return overflowedPixels_; }

private:
    uint32_t width_;
    uint32_t height_;
    double unit_;
    uint64_t blocks_ = 0;
    uint64_t nonFinitePixels_ = 0;
    uint64_t overflowedPixels_ = 0;
    std::vector<Sum> sums_;
};

} // namespace calotype
