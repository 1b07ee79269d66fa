#pragma once

#include <cstdint>
#include <span>

#include <glm/vec4.hpp>

#include "shared/render_structs.h"

namespace calotype {

/// Adds samples to one block of the film: samples of consecutive indices, summed per pixel in their
/// order.
class BlockTracer {
public:
    /// A range of the picture's tiles, in the tracer's order.
    struct TileRange {
        uint32_t first = 0;
        uint32_t count = 0;
    };

    virtual ~BlockTracer() = default;

    /// The number of tiles of the current block: at least those with pixels that are not left out.
    virtual uint32_t tileCount() const = 0;

    /// Empties the block; its next samples have absolute indices from `firstSample` on. Pixels that
    /// are left out (a byte each, 0 or 1; none: all are in) get no samples: readBlock returns a sum
    /// of 0 and the full number of samples for them.
    virtual void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut = {}) = 0;

    /// Adds samples to the pixels of at most kMostTilesPerDispatch tiles until each has `sampleEnd`
    /// samples of the block. One call may not suffice: call again with the same arguments while
    /// `unfinishedPixels` is not zero.
    virtual shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) = 0;

    /// The block so far: per pixel, row by row from the top left, the sum of r, g, b, and in w the
    /// number of samples (film/block_count.h). Valid until the next call.
    virtual std::span<const glm::vec4> readBlock() = 0;
};

} // namespace calotype
