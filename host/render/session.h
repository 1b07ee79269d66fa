#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "film/error_estimate.h"
#include "film/film.h"
#include "image/image.h"
#include "image/layers.h"
#include "image/picture.h"
#include "image/pixel_error.h"

namespace calotype {

/// Sums over a session so far.
struct RenderTotals {
    uint64_t rays = 0;
    uint64_t paths = 0;
    FilmLosses losses;                  ///< of the picture, whoever rendered it
    uint64_t samplesPerPixel = 0;       ///< of those that every pixel has, or else of the mean
    double seconds = 0.0;               ///< of sampling alone
    double firstSampleSeconds = 0.0;    ///< of sampling until every pixel had a sample
    std::optional<ErrorEstimate> error; ///< of the film's whole blocks, now and then
};

/// What ends a render before all its samples are there.
struct RenderGoal {
    /// ErrorEstimate::upperBound that is good enough, of an estimate that is to be trusted. It is
    /// looked at when the film holds 128, 256, 512, ... samples per pixel, because many looks would
    /// find by chance what is not so.
    std::optional<double> targetError;
    std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// What a session tells while it runs. Each may be empty.
struct RenderObserver {
    std::function<bool()> shouldStop; ///< asked after every dispatch, about ten times a second
    std::function<void(const RenderTotals&)> onDispatch;
    std::function<void(const RenderTotals&)> onPass; ///< all that pixels lacked has been added
    std::function<void()> onBlock;                   ///< the film has taken a block
};

enum class RenderEnding : uint8_t { AllSamples, TargetError, Deadline, Stopped };

/// Renders one picture, whichever samples it gives to which pixels.
class Session {
public:
    Session() = default;
    virtual ~Session() = default;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Renders until all samples are there, the goal is reached, or the observer stops it; a
    /// deadline leaves time for one sample in every pixel. `passSamples`, if not 0, makes a pass
    /// end at every multiple of it where that can be.
    virtual RenderEnding run(const RenderObserver& observer, uint32_t passSamples = 0,
                             const RenderGoal& goal = {}) = 0;

    /// The picture so far; pixels without a sample are black.
    virtual Image picture() = 0;

    /// Samples per pixel once all are there, those that the film held before among them.
    virtual uint64_t samplesInTheEnd() const = 0;

    virtual const RenderTotals& totals() const = 0;

    /// Of the whole blocks as they are; none where they are too few to tell.
    virtual const std::optional<ErrorEstimate>& error() = 0;
    virtual std::vector<PixelError> pixelErrors() const = 0;

    /// Of the whole blocks as well: the channels of a layer for which a film is enough.
    virtual std::vector<Channel> channelsOf(const Layer& layer) const = 0;
};

} // namespace calotype
