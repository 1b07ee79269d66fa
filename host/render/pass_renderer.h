#pragma once

#include <optional>

#include "render/block_tracer.h"
#include "render/dispatch_sizer.h"
#include "render/session.h"

namespace calotype {

/// Adds samples to a block's pixels in dispatches of bounded time.
class PassRenderer {
public:
    /// Adds to `totals`. Both arguments must outlive this object.
    PassRenderer(BlockTracer& tracer, RenderTotals& totals);

    /// Clears the losses of the previous block. If its tiles have many more pixels that get samples
    /// than the previous ones, the measured time of dispatches is discarded.
    void beginBlock(double pixelsPerTile = 0.0);

    /// Adds samples until every pixel has `sampleEnd` samples of the block. Returns how the render
    /// ended, or nothing if it goes on. A deadline only counts when every pixel has a sample.
    std::optional<RenderEnding> run(uint32_t sampleEnd, const RenderObserver& observer,
                                    const RenderGoal& goal);

    /// The losses of the block so far.
    const FilmLosses& losses() const { return losses_; }

private:
    BlockTracer& tracer_;
    RenderTotals& totals_;
    DispatchSizer sizer_;
    FilmLosses losses_;
    double pixelsPerTile_ = 0.0;
};

} // namespace calotype
