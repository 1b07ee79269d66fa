#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "denoise/denoised_error.h"
#include "denoise/film_view.h"
#include "image/image.h"
#include "image/layer.h"
#include "image/picture.h"
#include "image/pixel_error.h"
#include "render/render_totals.h"

namespace calotype {

/// What ends a render before it has all its samples.
struct RenderGoal {
    /// The render ends when ErrorEstimate::upperBound of a trusted estimate is at most this. It is
    /// checked at the looks of film/looks.h only, among which the chance of a wrong bound is
    /// divided.
    std::optional<double> targetError;
    /// Where it is set: the error that is compared with targetError in place of the film's own
    /// estimate; none if it is not known yet.
    std::function<std::optional<DenoisedError>(const FilmView&)> denoisedError;
    std::optional<std::chrono::steady_clock::time_point> deadline;
};

/// Callbacks of a running session. Each may be empty.
struct RenderObserver {
    std::function<bool()> shouldStop; ///< called after every dispatch, about ten times a second
    std::function<void(const RenderTotals&)> onDispatch;
    std::function<void(const RenderTotals&)> onPass; ///< the pixels have all samples of a pass
    std::function<void()> onBlock;                   ///< the film has added a block
};

/// Renders one picture. Derived classes decide which pixels get which samples.
class Session {
public:
    Session() = default;
    virtual ~Session() = default;
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    /// Renders until all samples are done, the goal is reached, or the observer stops it. A
    /// deadline leaves time for one sample in every pixel. If `passSamples` is not 0, passes end at
    /// multiples of it if possible.
    virtual RenderEnding run(const RenderObserver& observer, uint32_t passSamples = 0,
                             const RenderGoal& goal = {}) = 0;

    /// The picture so far; pixels without a sample are black.
    virtual Image picture() = 0;

    /// The share of each pixel's samples that show a surface; 0 without a sample. Empty if the
    /// background is not hidden from the camera.
    virtual std::vector<float> alpha() = 0;

    /// Samples per pixel at the end, including those that the film held before.
    virtual uint64_t samplesInTheEnd() const = 0;

    virtual const RenderTotals& totals() const = 0;

    /// The error of the film's whole blocks; none if they are too few for an estimate.
    virtual const std::optional<ErrorEstimate>& error() = 0;
    virtual std::vector<PixelError> pixelErrors() const = 0;

    /// The whole blocks.
    virtual FilmView filmView() const = 0;

    /// Also of the whole blocks: the channels of a layer that can be made from a film.
    virtual std::vector<Channel> channelsOf(const Layer& layer) const = 0;
};

} // namespace calotype
