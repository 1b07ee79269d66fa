#pragma once

#include <cstdint>
#include <span>

#include <glm/vec4.hpp>

#include "shared/render_structs.h"

namespace calotype {

/// What adds samples to one block of the film: consecutive sample indices, summed per pixel in
/// their order.
class BlockTracer {
public:
    /// A range of the picture's tiles, in the order in which the tracer takes them.
    struct TileRange {
        uint32_t first = 0;
        uint32_t count = 0;
    };

    virtual ~BlockTracer() = default;

    /// Of the block that was begun last: those with pixels that are not all left out, or more.
    virtual uint32_t tileCount() const = 0;

    /// Empties the block; its next samples have absolute indices from `firstSample` on. Pixels
    /// that are left out (a byte each, 0 or 1; none: all are in) get no samples: readBlock has a
    /// sum of 0 and all the block's samples for them.
    virtual void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut = {}) = 0;

    /// Brings the pixels of at most kMostTilesPerDispatch tiles to `sampleEnd` samples of the
    /// block, as far as one call may go: call again for the same while `unfinishedPixels` is not
    /// zero.
    virtual shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) = 0;

    /// The block so far: per pixel, row by row from the top left, the sum of r, g, b, and in w the
    /// number of samples. Valid until the next call.
    virtual std::span<const glm::vec4> readBlock() = 0;
};

} // namespace calotype
