#include "render/render_session.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "film/looks.h"
#include "shared/limits.h"

namespace calotype {
namespace {

using shared::kSamplesPerBlock;

/// The end of the pass that starts with `done` samples in every pixel. The first passes double the
/// samples; no pass crosses the end of a block, the last sample, or a multiple of `passSamples`.
uint64_t endOfPass(uint64_t done, uint64_t lastSample, uint32_t passSamples) {
    const auto nextMultiple = [done](uint64_t n) { return (done / n + 1) * n; };
    uint64_t end = std::min(nextMultiple(kSamplesPerBlock), lastSample);
    end = std::min(end, std::max(uint64_t{1}, 2 * done));
    return passSamples > 0 ? std::min(end, nextMultiple(passSamples)) : end;
}

} // namespace

RenderSession::RenderSession(BlockTracer& tracer, const RenderSettings& settings, Film film)
    : tracer_(tracer), settings_(settings), film_(std::move(film)), passes_(tracer, totals_) {
    CALOTYPE_CHECK_EQ(film_.width(), settings.crop.width);
    CALOTYPE_CHECK_EQ(film_.height(), settings.crop.height);
    CALOTYPE_CHECK_EQ(settings.firstSample % kSamplesPerBlock, 0u);
    totals_.samplesPerPixel = film_.samplesPerPixel();
    totals_.losses = film_.losses();
}

RenderSession::RenderSession(BlockTracer& tracer, const RenderSettings& settings,
                             double maxRadiance)
    : RenderSession(tracer, settings,
                    Film(settings.crop.width, settings.crop.height, filmUnit(maxRadiance),
                         detailFor(settings.denoiser), settings.transport.hidesBackground)) {}

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
    passes_.beginBlock();
    const uint64_t before = film_.samplesPerPixel();
    while (totals_.samplesPerPixel < before + blockEnd) {
        const bool isFirst = totals_.samplesPerPixel == 0;
        const uint64_t end = endOfPass(totals_.samplesPerPixel, before + blockEnd, passSamples);
        if (const auto ending = passes_.run(static_cast<uint32_t>(end - before), observer, goal))
            return ending;
        totals_.samplesPerPixel = end;
        if (isFirst)
            totals_.firstSampleSeconds = totals_.seconds;
        const bool isWhole = end - before == kSamplesPerBlock;
        if (isWhole) {
            film_.addBlock(block, tracer_.readBlock(), passes_.losses());
            blockIsInFilm_ = true;
            totals_.losses = film_.losses();
            if (watch_.isDue())
                error();
        }
        if (observer.onPass)
            observer.onPass(totals_);
        if (isWhole && observer.onBlock)
            observer.onBlock();
    }
    return isGoodEnough(goal) ? std::optional(RenderEnding::TargetError) : std::nullopt;
}

const std::optional<ErrorEstimate>& RenderSession::error() {
    watch_.update(film_, film_.samplesPerPixel(), totals_.error);
    return totals_.error;
}

bool RenderSession::isGoodEnough(const RenderGoal& goal) {
    if (!goal.targetError || !isLook(film_.samplesPerPixel()))
        return false;
    return goal.denoisedError ? isReachedDenoised(goal, film_, totals_) : isReached(goal, error());
}

Image RenderSession::picture() {
    return blockIsInFilm_ ? film_.picture() : film_.picture(tracer_.readBlock());
}

std::vector<float> RenderSession::alpha() {
    return blockIsInFilm_ ? film_.alpha() : film_.alpha(tracer_.readBlock());
}

} // namespace calotype
