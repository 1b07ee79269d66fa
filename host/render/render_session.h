#pragma once

#include <cstdint>
#include <functional>

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
    uint64_t nonFiniteSamples = 0; ///< counted as samples of value zero
    uint64_t cutPaths = 0;         ///< ended by the loop budget of one dispatch
    uint64_t lostBlocks = 0;      ///< of one pixel each: sums not finite or too bright for the film
    uint32_t samplesPerPixel = 0; ///< that every pixel has
    double seconds = 0.0;         ///< of sampling alone
    double firstSampleSeconds = 0.0; ///< of sampling until every pixel had a sample
};

/// What a session tells while it runs. Each may be empty.
struct RenderObserver {
    std::function<bool()> shouldStop; ///< asked after every dispatch, about ten times a second
    std::function<void(const RenderTotals&)> onDispatch;
    std::function<void(const RenderTotals&)> onPass; ///< every pixel has `samplesPerPixel`
};

/// Renders a picture, pass after pass: every pixel has 1, 2, 4, 8, then 16 samples, and 16 more
/// after each further pass. Each pass is cut into short dispatches. The film takes whole blocks;
/// samples of an unfinished one show in the picture only.
class RenderSession {
public:
    RenderSession(BlockTracer& tracer, const RenderSettings& settings, double maxRadiance);

    /// Renders until all samples are there or the observer stops it. True if all are there.
    /// `passSamples`, if not 0, makes a pass end at every multiple of it.
    bool run(const RenderObserver& observer, uint32_t passSamples = 0);

    /// The mean so far; pixels without a sample are black.
    Image picture();

    const RenderTotals& totals() const { return totals_; }

private:
    /// Brings every pixel to `sampleEnd` samples of the block. False if stopped.
    bool renderPass(uint32_t sampleEnd, const RenderObserver& observer);
    void add(const gpu::RenderCounters& counters);

    BlockTracer& tracer_;
    RenderSettings settings_;
    Film film_;
    DispatchSizer sizer_;
    RenderTotals totals_;
    bool blockIsInFilm_ = true; ///< else the storage image holds samples that the film lacks
};

} // namespace calotype
