#include "render/render_session.h"

#include <algorithm>
#include <chrono>

#include "shared/limits.h"

namespace calotype {
namespace {

/// Samples that a pass adds, at most: a whole block.
constexpr uint32_t kMaxPassSamples = gpu::kSamplesPerBlock;

/// Where the pass ends that begins with `done` samples in every pixel: the first doubles, none
/// crosses a multiple of kMaxPassSamples, the last sample, or a multiple of `passSamples`.
uint32_t endOfPass(uint32_t done, uint32_t samplesPerPixel, uint32_t passSamples) {
    const auto nextMultiple = [done](uint32_t n) { return (done / n + 1) * n; };
    uint32_t end = std::min(nextMultiple(kMaxPassSamples), samplesPerPixel);
    end = std::min(end, std::max(1u, 2 * done));
    return passSamples > 0 ? std::min(end, nextMultiple(passSamples)) : end;
}

} // namespace

RenderSession::RenderSession(BlockTracer& tracer, const RenderSettings& settings,
                             double maxRadiance)
    : tracer_(tracer), settings_(settings),
      film_(settings.crop.width, settings.crop.height, filmUnit(maxRadiance)),
      sizer_(std::min(tracer.tileCount(), gpu::kMostTilesPerDispatch)) {}

bool RenderSession::run(const RenderObserver& observer, uint32_t passSamples) {
    while (totals_.samplesPerPixel < settings_.samplesPerPixel) {
        const uint32_t done = totals_.samplesPerPixel;
        const uint32_t blockStart = done - done % gpu::kSamplesPerBlock;
        if (done == blockStart) {
            tracer_.beginBlock(blockStart);
            blockIsInFilm_ = false;
        }
        const uint32_t end = endOfPass(done, settings_.samplesPerPixel, passSamples);
        if (!renderPass(end - blockStart, observer))
            return false;
        if (end - blockStart == gpu::kSamplesPerBlock) {
            film_.addBlock(tracer_.readBlock());
            blockIsInFilm_ = true;
            totals_.lostBlocks = film_.overflowedPixels() + film_.nonFinitePixels();
        }
        totals_.samplesPerPixel = end;
        if (done == 0)
            totals_.firstSampleSeconds = totals_.seconds;
        if (observer.onPass)
            observer.onPass(totals_);
    }
    return true;
}

bool RenderSession::renderPass(uint32_t sampleEnd, const RenderObserver& observer) {
    using Clock = std::chrono::steady_clock;
    uint32_t first = 0;
    uint32_t count = 0; // of the dispatch that is not finished
    while (first < tracer_.tileCount()) {
        if (count == 0)
            count = std::min(sizer_.tiles(), tracer_.tileCount() - first);
        const Clock::time_point before = Clock::now();
        const gpu::RenderCounters counters = tracer_.renderTiles({first, count}, sampleEnd);
        const Clock::time_point after = Clock::now();
        const double seconds = std::chrono::duration<double>(after - before).count();
        sizer_.update(count, seconds);
        add(counters);
        totals_.seconds += seconds;
        if (counters.unfinishedPixels == 0) {
            first += count;
            count = 0;
        }
        if (observer.onDispatch)
            observer.onDispatch(totals_);
        if (observer.shouldStop && observer.shouldStop())
            return false;
    }
    return true;
}

void RenderSession::add(const gpu::RenderCounters& counters) {
    totals_.rays += counters.rays;
    totals_.paths += counters.paths;
    totals_.nonFiniteSamples += counters.nonFiniteSamples;
    totals_.cutPaths += counters.cutPaths;
}

Image RenderSession::picture() {
    return blockIsInFilm_ ? film_.picture() : film_.picture(tracer_.readBlock());
}

} // namespace calotype
