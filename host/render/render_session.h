#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>

#include "film/error_estimate.h"
#include "film/film.h"
#include "image/image.h"
#include "render/block_tracer.h"
#include "render/dispatch_sizer.h"
#include "render/render_settings.h"

namespace calotype {

/// Sums over a session so far.
struct RenderTotals {
    uint64_t rays = 0;
    uint64_t paths = 0;
    FilmLosses losses;               ///< of the picture, whoever rendered it
    uint64_t samplesPerPixel = 0;    ///< that every pixel has, those of the film before among them
    double seconds = 0.0;            ///< of sampling alone
    double firstSampleSeconds = 0.0; ///< of sampling until every pixel had a sample
    std::optional<ErrorEstimate> error; ///< of the film's whole blocks, now and then
};

/// What ends a render before all its samples are there.
struct RenderGoal {
    /// ErrorEstimate::upperBound that is good enough, of an estimate that is to be trusted. It is
    /// looked at when the film holds 128, 256, 512, ... samples per pixel, lest many looks find by
    /// chance what is not so.
    std::optional<double> targetError;
    std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// What a session tells while it runs. Each may be empty.
struct RenderObserver {
    std::function<bool()> shouldStop; ///< asked after every dispatch, about ten times a second
    std::function<void(const RenderTotals&)> onDispatch;
    std::function<void(const RenderTotals&)> onPass; ///< every pixel has `samplesPerPixel`
    std::function<void()> onBlock;                   ///< the film has taken a block
};

enum class RenderEnding : uint8_t { AllSamples, TargetError, Deadline, Stopped };

/// Renders a picture, pass after pass: every pixel has 1, 2, 4, 8, then 16 samples, and 16 more
/// after each further pass. Each pass is cut into short dispatches. The film takes whole blocks;
/// samples of an unfinished one show in the picture only.
class RenderSession {
public:
    /// Goes on with a film of the crop's size: what it holds of the samples is not rendered again.
    RenderSession(BlockTracer& tracer, const RenderSettings& settings, Film film);

    /// Begins with an empty film.
    RenderSession(BlockTracer& tracer, const RenderSettings& settings, double maxRadiance);

    /// Renders until all samples are there, the goal is reached, or the observer stops it; a
    /// deadline leaves time for one sample in every pixel. `passSamples`, if not 0, makes a pass
    /// end at every multiple of it.
    RenderEnding run(const RenderObserver& observer, uint32_t passSamples = 0,
                     const RenderGoal& goal = {});

    /// The mean so far; pixels without a sample are black.
    Image picture();

    /// Samples per pixel once all are there, those that the film held before among them.
    uint64_t samplesInTheEnd() const;

    const Film& film() const { return film_; }
    const RenderTotals& totals() const { return totals_; }

    /// Of the film as it is; none where it is too small to tell.
    const std::optional<ErrorEstimate>& error();

private:
    using Clock = std::chrono::steady_clock;

    /// Of the settings' samples, the blocks that the film lacks.
    BlockRanges missingBlocks() const;
    /// Of the settings' samples, those in a block.
    uint32_t samplesIn(uint32_t block) const;
    /// Renders samples of a block, the film's next, up to `blockEnd` of it. How it ended, if early.
    std::optional<RenderEnding> renderBlock(uint32_t block, uint32_t blockEnd,
                                            const RenderObserver& observer, uint32_t passSamples,
                                            const RenderGoal& goal);
    /// Brings every pixel to `sampleEnd` samples of the block.
    std::optional<RenderEnding> renderPass(uint32_t sampleEnd, const RenderObserver& observer,
                                           const RenderGoal& goal);
    void add(const gpu::RenderCounters& counters);
    bool isGoodEnough(const RenderGoal& goal);
    void updateErrorNowAndThen();

    BlockTracer& tracer_;
    RenderSettings settings_;
    Film film_;
    DispatchSizer sizer_;
    RenderTotals totals_;
    FilmLosses blockLosses_;     ///< of the block that the film has not taken yet
    bool blockIsInFilm_ = true;  ///< else the storage image holds samples that the film lacks
    uint64_t samplesJudged_ = 0; ///< that the film held when its error was last estimated
    double estimateSeconds_ = 0.0;
    Clock::time_point lastEstimate_;
};

} // namespace calotype
