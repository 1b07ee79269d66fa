#pragma once

#include <optional>

#include "render/block_tracer.h"
#include "render/dispatch_sizer.h"
#include "render/session.h"

namespace calotype {

/// Adds samples to a block's pixels in dispatches of bounded time.
class PassRenderer {
public:
    /// Counts into `totals`. Both must outlive this.
    PassRenderer(BlockTracer& tracer, RenderTotals& totals);

    /// Forgets the losses of the block before. Where its tiles have many more pixels that get
    /// samples than those before, what was learnt of the time of dispatches does not hold.
    void beginBlock(double pixelsPerTile = 0.0);

    /// Brings every pixel to `sampleEnd` samples of the block. How it ended, if early; a deadline
    /// counts once `totals` knows of a sample in every pixel.
    std::optional<RenderEnding> run(uint32_t sampleEnd, const RenderObserver& observer,
                                    const RenderGoal& goal);

    /// Of the block so far.
    const FilmLosses& losses() const { return losses_; }

private:
    BlockTracer& tracer_;
    RenderTotals& totals_;
    DispatchSizer sizer_;
    FilmLosses losses_;
    double pixelsPerTile_ = 0.0;
};

} // namespace calotype
