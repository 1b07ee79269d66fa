#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "film/adaptive_film.h"
#include "film/develop.h"
#include "render/block_tracer.h"
#include "render/error_watch.h"
#include "render/pass_renderer.h"
#include "render/session.h"
#include "settings/render_settings.h"

namespace calotype {

/// Renders a picture in rounds of 128, 256, 512, ... samples per pixel on average, the last one of
/// the settings' number. A round first gives every pixel an eighth to a quarter of that, at least
/// 128: a survey.
/// Then each half of the film deals out the rest to its pixels by the survey that the other half
/// made, see AdaptiveFilm. So the picture depends on the settings alone, and has no bias.
///
/// All samples come in whole blocks of both halves. The first round's are those that a
/// RenderSession takes.
class AdaptiveSession : public Session {
public:
    AdaptiveSession(BlockTracer& tracer, const RenderSettings& settings, double maxRadiance);

    RenderEnding run(const RenderObserver& observer, uint32_t passSamples = 0,
                     const RenderGoal& goal = {}) override;
    Image picture() override;
    uint64_t samplesInTheEnd() const override;
    const RenderTotals& totals() const override { return totals_; }
    const std::optional<ErrorEstimate>& error() override;
    std::vector<PixelError> pixelErrors() const override { return calotype::pixelErrors(film_); }
    std::vector<Channel> channelsOf(const Layer& layer) const override {
        return calotype::channelsOf(layer, film_);
    }

    const AdaptiveFilm& film() const { return film_; }

private:
    using Targets = std::array<std::vector<uint32_t>, AdaptiveFilm::kHalves>;

    /// Blocks of each half that all pixels are to have at least.
    Targets atLeast(uint32_t blocks) const;
    /// Blocks of each half for a mean of `blocks`, by the surveys of a level.
    Targets dealOut(uint32_t blocks, uint32_t level) const;

    /// Renders the blocks that pixels lack. How it ended, if early.
    std::optional<RenderEnding> fill(const Targets& targets, const RenderObserver& observer,
                                     const RenderGoal& goal);
    std::optional<RenderEnding> renderBlock(uint32_t block, const RenderObserver& observer,
                                            const RenderGoal& goal);

    BlockTracer& tracer_;
    RenderSettings settings_;
    AdaptiveFilm film_;
    RenderTotals totals_;
    PassRenderer passes_;
    ErrorWatch watch_;
    uint32_t blockHalf_ = 0;         ///< of the block that is being rendered
    std::vector<uint8_t> isLeftOut_; ///< pixels without samples of it
    bool blockIsInFilm_ = true;      ///< else the storage image holds samples that the film lacks
};

} // namespace calotype
