#pragma once

#include <cstddef>
#include <vector>

#include <glm/vec3.hpp>

#include "render/block_tracer.h"

namespace calotype::test {

/// The mean radiance of each tile of 8 x 8 pixels, block of samples by block.
class TileMeans {
public:
    TileMeans(size_t tiles, size_t blocks) : tiles_(tiles), values_(tiles * blocks) {}

    size_t tiles() const { return tiles_; }
    size_t blocks() const { return values_.size() / tiles_; }
    glm::dvec3& at(size_t block, size_t tile) { return values_[block * tiles_ + tile]; }
    const glm::dvec3& at(size_t block, size_t tile) const { return values_[block * tiles_ + tile]; }
    glm::dvec3 whole(size_t block) const; ///< of the picture

private:
    size_t tiles_;
    std::vector<glm::dvec3> values_;
};

/// Renders whole blocks of samples of a picture whose sides are multiples of 8, from the block
/// `first` on. Fails the test where a sample is not finite or a path is cut.
TileMeans renderTileMeans(BlockTracer& tracer, uint32_t width, uint32_t height, size_t blocks,
                          size_t first = 0);

/// How far two renderings of one scene from independent random numbers lie apart. Each z is a
/// standard normal deviate if they agree.
struct Agreement {
    glm::dvec3 wholeZ{0.0};        ///< of the picture's mean, by channel
    double greatestTileZ = 0.0;    ///< by magnitude, over tiles and channels
    glm::dvec3 tileChiSquare{0.0}; ///< sum of the tiles' z^2, by channel
    size_t tiles = 0;              ///< the degrees of freedom of that sum
};

/// Welch's t-test over the blocks, on every tile and on the whole picture.
Agreement compareIndependent(const TileMeans& a, const TileMeans& b);

/// The difference of the picture's means relative to b's (above 0), by channel, and its error, of
/// two renderings from the same random numbers: block by block, so that what both do alike cancels.
struct PairedDifference {
    glm::dvec3 relative{0.0};
    glm::dvec3 standardError{0.0};
};
PairedDifference comparePaired(const TileMeans& a, const TileMeans& b);

/// The share of pixels whose first samples, from the same random numbers, differ by more than a
/// thousandth of the reference's value and of its picture's mean together. NaN differs too.
double differingShare(BlockTracer& device, BlockTracer& reference);
/// Likewise of samples in the same order.
double differingShare(const std::vector<glm::dvec3>& found,
                      const std::vector<glm::dvec3>& expected);

/// Of a vector's components.
double largest(const glm::dvec3& v);

/// What a standard normal deviate stays below in magnitude, `count` of them together, but for once
/// in 10,000 times.
double normalLimit(size_t count);

} // namespace calotype::test
