#include "render/pass_renderer.h"

#include <algorithm>
#include <chrono>

#include "base/stopwatch.h"
#include "shared/limits.h"

namespace calotype {

PassRenderer::PassRenderer(BlockTracer& tracer, RenderTotals& totals)
    : tracer_(tracer), totals_(totals), sizer_(shared::kMostTilesPerDispatch) {}

void PassRenderer::beginBlock(double pixelsPerTile) {
    losses_ = {};
    if (pixelsPerTile > 1.5 * pixelsPerTile_)
        sizer_ = DispatchSizer(shared::kMostTilesPerDispatch);
    pixelsPerTile_ = pixelsPerTile;
}

std::optional<RenderEnding> PassRenderer::run(uint32_t sampleEnd, const RenderObserver& observer,
                                              const RenderGoal& goal) {
    using Clock = std::chrono::steady_clock;
    uint32_t first = 0;
    uint32_t count = 0; // of the dispatches that are not finished
    while (first < tracer_.tileCount()) {
        if (count == 0)
            count = std::min(sizer_.tiles(), tracer_.tileCount() - first);
        const Clock::time_point before = Clock::now();
        const shared::RenderCounters counters = tracer_.renderTiles({first, count}, sampleEnd);
        const double seconds = secondsSince(before);
        sizer_.update(count, seconds);
        totals_.seconds += seconds;
        totals_.rays += counters.rays;
        totals_.paths += counters.paths;
        losses_ += {counters.nonFiniteSamples, counters.cutPaths, 0, 0};
        totals_.losses += {counters.nonFiniteSamples, counters.cutPaths, 0, 0};
        if (counters.unfinishedPixels == 0) {
            first += count;
            count = 0;
        }
        if (observer.onDispatch)
            observer.onDispatch(totals_);
        if (observer.shouldStop && observer.shouldStop())
            return RenderEnding::Stopped;
        if (goal.deadline && totals_.samplesPerPixel > 0 && Clock::now() >= *goal.deadline)
            return RenderEnding::Deadline;
    }
    return std::nullopt;
}

} // namespace calotype
