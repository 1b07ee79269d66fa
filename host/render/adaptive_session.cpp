#include "render/adaptive_session.h"

#include <algorithm>
#include <bit>

#include "film/allocate_blocks.h"
#include "film/looks.h"
#include "shared/limits.h"

namespace calotype {
namespace {

using shared::kSamplesPerBlock;

constexpr uint32_t kHalves = AdaptiveFilm::kHalves;

/// Samples per pixel of a block in each half.
constexpr uint32_t kSamplesPerStep = kHalves * kSamplesPerBlock;

/// Blocks of each half for the first survey: one of every replica.
constexpr uint32_t kFirstBlocks = AdaptiveFilm::kReplicasPerHalf;

/// A survey gets this share of the samples of its round, 1 / 4.
constexpr uint32_t kSurveyShare = 4;

/// No pixel gets more than this many times the mean, or more than a film can hold.
constexpr uint32_t kMostOfMean = 8;
constexpr uint32_t kMostBlocks = Film::kMaxBlocks / kHalves;

uint32_t blocksFor(uint32_t samples) { return (samples + kSamplesPerStep - 1) / kSamplesPerStep; }

/// A round of `blocks` blocks of each half uses the survey of 4 * 2^level blocks of each half.
uint32_t surveyLevel(uint32_t blocks) {
    const uint32_t most = std::max(kFirstBlocks, blocks / kSurveyShare);
    return static_cast<uint32_t>(std::bit_width(most / kFirstBlocks)) - 1;
}

} // namespace

AdaptiveSession::AdaptiveSession(BlockTracer& tracer, const RenderSettings& settings,
                                 double maxRadiance)
    : tracer_(tracer), settings_(settings),
      film_(settings.crop.width, settings.crop.height, filmUnit(maxRadiance),
            detailFor(settings.denoiser), settings.transport.hidesBackground),
      passes_(tracer, totals_) {}

RenderEnding AdaptiveSession::run(const RenderObserver& observer, uint32_t /*passSamples*/,
                                  const RenderGoal& goal) {
    const uint32_t last = blocksFor(settings_.samplesPerPixel);
    for (uint32_t blocks = std::min(kFirstBlocks, last);; blocks = std::min(2 * blocks, last)) {
        const uint32_t level = surveyLevel(blocks);
        const uint32_t surveyed = std::min(kFirstBlocks << level, blocks);
        if (const auto ending = fill(atLeast(surveyed), observer, goal))
            return *ending;
        film_.forgetSurveysBelow(level);
        if (surveyed < blocks)
            if (const auto ending = fill(dealOut(blocks, level), observer, goal))
                return *ending;
        if (blocks == last)
            return RenderEnding::AllSamples;
    }
}

AdaptiveSession::Targets AdaptiveSession::atLeast(uint32_t blocks) const {
    Targets targets;
    for (uint32_t half = 0; half < kHalves; ++half)
        for (const uint32_t done : film_.blocksOf(half))
            targets[half].push_back(std::max(done, blocks));
    return targets;
}

AdaptiveSession::Targets AdaptiveSession::dealOut(uint32_t blocks, uint32_t level) const {
    Targets targets;
    for (uint32_t half = 0; half < kHalves; ++half) {
        const uint32_t other = 1 - half;
        targets[half] = allocateBlocks(
            film_.survey(other, level), film_.width(), film_.blocksOf(half),
            std::min(kMostOfMean * blocks, kMostBlocks), uint64_t{blocks} * film_.pixelCount());
    }
    return targets;
}

std::optional<RenderEnding> AdaptiveSession::fill(const Targets& targets,
                                                  const RenderObserver& observer,
                                                  const RenderGoal& goal) {
    uint32_t least = ~0u;
    uint32_t most = 0;
    for (uint32_t half = 0; half < kHalves; ++half) {
        least = std::min(least, *std::ranges::min_element(film_.blocksOf(half)));
        most = std::max(most, *std::ranges::max_element(targets[half]));
    }
    for (uint32_t block = kHalves * least; block < kHalves * most; ++block) {
        blockHalf_ = block % kHalves;
        isLeftOut_.resize(film_.pixelCount());
        std::ranges::transform(film_.blocksOf(blockHalf_), targets[blockHalf_], isLeftOut_.begin(),
                               [&](uint32_t done, uint32_t target) {
                                   const uint32_t index = block / kHalves;
                                   return done <= index && index < target ? 0 : 1;
                               });
        if (std::ranges::count(isLeftOut_, 0) > 0)
            if (const auto ending = renderBlock(block, observer, goal))
                return ending;
        if (blockHalf_ == kHalves - 1 && isGoodEnough(goal))
            return RenderEnding::TargetError;
    }
    return std::nullopt;
}

bool AdaptiveSession::isGoodEnough(const RenderGoal& goal) {
    if (!goal.targetError || totals_.samplesPerPixel < nextLook_)
        return false;
    nextLook_ = lookAfter(totals_.samplesPerPixel);
    return goal.denoisedError ? isReachedDenoised(goal, film_, totals_) : isReached(goal, error());
}

std::optional<RenderEnding> AdaptiveSession::renderBlock(uint32_t block,
                                                         const RenderObserver& observer,
                                                         const RenderGoal& goal) {
    tracer_.beginBlock(kSamplesPerBlock * block, isLeftOut_);
    passes_.beginBlock(static_cast<double>(std::ranges::count(isLeftOut_, 0)) /
                       tracer_.tileCount());
    blockIsInFilm_ = false;
    const bool isFirst = film_.samples() == 0;
    for (uint32_t end = isFirst ? 1 : kSamplesPerBlock; end <= kSamplesPerBlock; end *= 2) {
        if (const auto ending = passes_.run(end, observer, goal))
            return ending;
        if (isFirst)
            totals_.samplesPerPixel = end;
        if (end == 1)
            totals_.firstSampleSeconds = totals_.seconds;
        if (end < kSamplesPerBlock && observer.onPass)
            observer.onPass(totals_);
    }
    film_.addBlock(block, tracer_.readBlock(), isLeftOut_, passes_.losses());
    blockIsInFilm_ = true;
    totals_.losses = film_.losses();
    totals_.samplesPerPixel = film_.samples() / film_.pixelCount();
    if (watch_.isDue())
        error();
    if (observer.onPass)
        observer.onPass(totals_);
    if (observer.onBlock)
        observer.onBlock();
    return std::nullopt;
}

const std::optional<ErrorEstimate>& AdaptiveSession::error() {
    watch_.update(film_, film_.samples(), totals_.error);
    return totals_.error;
}

uint64_t AdaptiveSession::samplesInTheEnd() const {
    return uint64_t{kSamplesPerStep} * blocksFor(settings_.samplesPerPixel);
}

Image AdaptiveSession::picture() {
    return blockIsInFilm_ ? film_.picture()
                          : film_.picture(blockHalf_, tracer_.readBlock(), isLeftOut_);
}

std::vector<float> AdaptiveSession::alpha() {
    return blockIsInFilm_ ? film_.alpha()
                          : film_.alpha(blockHalf_, tracer_.readBlock(), isLeftOut_);
}

} // namespace calotype
