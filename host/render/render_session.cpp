#include "render/render_session.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "base/check.h"
#include "base/stopwatch.h"
#include "shared/limits.h"

namespace calotype {
namespace {

using gpu::kSamplesPerBlock;

/// The least samples that a render may be judged by: one block of every replica.
constexpr uint64_t kFirstLook = uint64_t{gpu::kReplicas} * kSamplesPerBlock;

/// Estimating the error takes no more than this share of the time.
constexpr double kEstimateShare = 0.02;

/// Where the pass ends that begins with `done` samples in every pixel: the first doubles, none
/// crosses the end of a block, the last sample, or a multiple of `passSamples`.
uint64_t endOfPass(uint64_t done, uint64_t lastSample, uint32_t passSamples) {
    const auto nextMultiple = [done](uint64_t n) { return (done / n + 1) * n; };
    uint64_t end = std::min(nextMultiple(kSamplesPerBlock), lastSample);
    end = std::min(end, std::max(uint64_t{1}, 2 * done));
    return passSamples > 0 ? std::min(end, nextMultiple(passSamples)) : end;
}

} // namespace

RenderSession::RenderSession(BlockTracer& tracer, const RenderSettings& settings, Film film)
    : tracer_(tracer), settings_(settings), film_(std::move(film)),
      sizer_(std::min(tracer.tileCount(), gpu::kMostTilesPerDispatch)) {
    CALOTYPE_CHECK_EQ(film_.width(), settings.crop.width);
    CALOTYPE_CHECK_EQ(film_.height(), settings.crop.height);
    CALOTYPE_CHECK_EQ(settings.firstSample % kSamplesPerBlock, 0u);
    totals_.samplesPerPixel = film_.samplesPerPixel();
    totals_.losses = film_.losses();
}

RenderSession::RenderSession(BlockTracer& tracer, const RenderSettings& settings,
                             double maxRadiance)
    : RenderSession(tracer, settings,
                    Film(settings.crop.width, settings.crop.height, filmUnit(maxRadiance))) {}

RenderEnding RenderSession::run(const RenderObserver& observer, uint32_t passSamples,
                                const RenderGoal& goal) {
    if (isGoodEnough(goal))
        return RenderEnding::TargetError;
    const BlockRanges missing = missingBlocks();
    for (const BlockRange& range : missing.ranges())
        for (uint32_t block = range.begin; block < range.end; ++block)
            if (const auto ending =
                    renderBlock(block, samplesIn(block), observer, passSamples, goal))
                return *ending;
    return RenderEnding::AllSamples;
}

BlockRanges RenderSession::missingBlocks() const {
    const uint32_t end = settings_.firstSample + settings_.samplesPerPixel;
    return film_.blocks().missingFrom({settings_.firstSample / kSamplesPerBlock,
                                       (end + kSamplesPerBlock - 1) / kSamplesPerBlock});
}

uint32_t RenderSession::samplesIn(uint32_t block) const {
    const uint32_t end = settings_.firstSample + settings_.samplesPerPixel;
    return std::min(end - kSamplesPerBlock * block, kSamplesPerBlock);
}

uint64_t RenderSession::samplesInTheEnd() const {
    uint64_t samples = film_.samplesPerPixel();
    const BlockRanges missing = missingBlocks();
    for (const BlockRange& range : missing.ranges())
        samples +=
            uint64_t{kSamplesPerBlock} * (range.end - range.begin - 1) + samplesIn(range.end - 1);
    return samples;
}

std::optional<RenderEnding> RenderSession::renderBlock(uint32_t block, uint32_t blockEnd,
                                                       const RenderObserver& observer,
                                                       uint32_t passSamples,
                                                       const RenderGoal& goal) {
    tracer_.beginBlock(kSamplesPerBlock * block);
    blockIsInFilm_ = false;
    blockLosses_ = {};
    const uint64_t before = film_.samplesPerPixel();
    while (totals_.samplesPerPixel < before + blockEnd) {
        const bool isFirst = totals_.samplesPerPixel == 0;
        const uint64_t end = endOfPass(totals_.samplesPerPixel, before + blockEnd, passSamples);
        if (const auto ending = renderPass(static_cast<uint32_t>(end - before), observer, goal))
            return ending;
        totals_.samplesPerPixel = end;
        if (isFirst)
            totals_.firstSampleSeconds = totals_.seconds;
        const bool isWhole = end - before == kSamplesPerBlock;
        if (isWhole) {
            film_.addBlock(block, tracer_.readBlock(), blockLosses_);
            blockIsInFilm_ = true;
            totals_.losses = film_.losses();
            updateErrorNowAndThen();
        }
        if (observer.onPass)
            observer.onPass(totals_);
        if (isWhole && observer.onBlock)
            observer.onBlock();
    }
    return isGoodEnough(goal) ? std::optional(RenderEnding::TargetError) : std::nullopt;
}

std::optional<RenderEnding> RenderSession::renderPass(uint32_t sampleEnd,
                                                      const RenderObserver& observer,
                                                      const RenderGoal& goal) {
    uint32_t first = 0;
    uint32_t count = 0; // of the dispatch that is not finished
    while (first < tracer_.tileCount()) {
        if (count == 0)
            count = std::min(sizer_.tiles(), tracer_.tileCount() - first);
        const Clock::time_point before = Clock::now();
        const gpu::RenderCounters counters = tracer_.renderTiles({first, count}, sampleEnd);
        const double seconds = secondsSince(before);
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
            return RenderEnding::Stopped;
        if (goal.deadline && totals_.samplesPerPixel > 0 && Clock::now() >= *goal.deadline)
            return RenderEnding::Deadline;
    }
    return std::nullopt;
}

void RenderSession::add(const gpu::RenderCounters& counters) {
    totals_.rays += counters.rays;
    totals_.paths += counters.paths;
    blockLosses_ += {counters.nonFiniteSamples, counters.cutPaths, 0, 0};
    totals_.losses += {counters.nonFiniteSamples, counters.cutPaths, 0, 0};
}

const std::optional<ErrorEstimate>& RenderSession::error() {
    if (samplesJudged_ != film_.samplesPerPixel()) {
        const Clock::time_point before = Clock::now();
        totals_.error = estimateError(film_);
        samplesJudged_ = film_.samplesPerPixel();
        estimateSeconds_ = secondsSince(before);
        lastEstimate_ = Clock::now();
    }
    return totals_.error;
}

void RenderSession::updateErrorNowAndThen() {
    if (samplesJudged_ == 0 || kEstimateShare * secondsSince(lastEstimate_) >= estimateSeconds_)
        error();
}

bool RenderSession::isGoodEnough(const RenderGoal& goal) {
    const uint64_t samples = film_.samplesPerPixel();
    const bool isLook = samples >= kFirstLook && std::has_single_bit(samples);
    return goal.targetError && isLook && error() && error()->isTrusted() &&
           error()->upperBound() <= *goal.targetError;
}

Image RenderSession::picture() {
    return blockIsInFilm_ ? film_.picture() : film_.picture(tracer_.readBlock());
}

} // namespace calotype
