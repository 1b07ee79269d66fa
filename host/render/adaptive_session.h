#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "film/adaptive_film.h"
#include "film/develop.h"
#include "film/looks.h"
#include "render/block_tracer.h"
#include "render/error_watch.h"
#include "render/pass_renderer.h"
#include "render/session.h"
#include "settings/render_settings.h"

namespace calotype {

/// Renders a picture in rounds of 128, 256, 512, ... samples per pixel on average. The last round
/// ends at the number of samples in the settings. A round first gives every pixel an eighth to a
/// quarter of its samples, at least 128: a survey.
/// Then each half of the film distributes the rest of its samples to pixels by the survey of the
/// other half, see AdaptiveFilm. So the picture depends on the settings only, and has no bias.
///
/// All samples are whole blocks of both halves. The first round takes the same samples as a
/// RenderSession.
class AdaptiveSession : public Session {
public:
    AdaptiveSession(BlockTracer& tracer, const RenderSettings& settings, double maxRadiance);

    RenderEnding run(const RenderObserver& observer, uint32_t passSamples = 0,
                     const RenderGoal& goal = {}) override;
    Image picture() override;
    std::vector<float> alpha() override;
    uint64_t samplesInTheEnd() const override;
    const RenderTotals& totals() const override { return totals_; }
    const std::optional<ErrorEstimate>& error() override;
    std::vector<PixelError> pixelErrors() const override { return calotype::pixelErrors(film_); }
    std::vector<Channel> channelsOf(const Layer& layer) const override {
        return calotype::channelsOf(layer, film_);
    }

    FilmView filmView() const override { return film_; }
    const AdaptiveFilm& film() const { return film_; }

private:
    using Targets = std::array<std::vector<uint32_t>, AdaptiveFilm::kHalves>;

    /// Targets of at least `blocks` blocks of each half for all pixels.
    Targets atLeast(uint32_t blocks) const;
    /// Blocks of each half for a mean of `blocks`, distributed by the surveys of `level`.
    Targets dealOut(uint32_t blocks, uint32_t level) const;

    /// Renders the blocks that pixels lack. Returns how the render ended, or nothing if it goes on.
    std::optional<RenderEnding> fill(const Targets& targets, const RenderObserver& observer,
                                     const RenderGoal& goal);
    std::optional<RenderEnding> renderBlock(uint32_t block, const RenderObserver& observer,
                                            const RenderGoal& goal);

    /// Also between rounds: the film is one of equal halves with fewer samples where noise is
    /// largest.
    bool isGoodEnough(const RenderGoal& goal);

    BlockTracer& tracer_;
    RenderSettings settings_;
    AdaptiveFilm film_;
    RenderTotals totals_;
    PassRenderer passes_;
    ErrorWatch watch_;
    uint64_t nextLook_ = kFirstLook;
    uint32_t blockHalf_ = 0;         ///< of the block that is rendered
    std::vector<uint8_t> isLeftOut_; ///< pixels that get no samples of it
    bool blockIsInFilm_ = true;      ///< false: the storage image holds samples that the film lacks
};

} // namespace calotype
