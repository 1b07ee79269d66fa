#pragma once

#include <cstdint>
#include <optional>

#include "film/develop.h"
#include "film/film.h"
#include "render/block_tracer.h"
#include "render/error_watch.h"
#include "render/pass_renderer.h"
#include "render/session.h"
#include "settings/render_settings.h"

namespace calotype {

/// Renders a picture in passes: after them every pixel has 1, 2, 4, 8, then 16 samples, and 16 more
/// after each further pass. A pass is split into short dispatches. The film adds whole blocks only;
/// the samples of an unfinished block are in the picture only.
class RenderSession : public Session {
public:
    /// Continues a film of the crop's size: samples that it holds are not rendered again.
    RenderSession(BlockTracer& tracer, const RenderSettings& settings, Film film);

    /// Begins with an empty film.
    RenderSession(BlockTracer& tracer, const RenderSettings& settings, double maxRadiance);

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
    const Film& film() const { return film_; }

private:
    /// The blocks of the settings' samples that the film lacks.
    BlockRanges missingBlocks() const;
    /// The number of the settings' samples in a block.
    uint32_t samplesIn(uint32_t block) const;
    /// Renders the film's next block up to `blockEnd` samples. Returns how it ended, if early.
    std::optional<RenderEnding> renderBlock(uint32_t block, uint32_t blockEnd,
                                            const RenderObserver& observer, uint32_t passSamples,
                                            const RenderGoal& goal);
    bool isGoodEnough(const RenderGoal& goal);

    BlockTracer& tracer_;
    RenderSettings settings_;
    Film film_;
    RenderTotals totals_;
    PassRenderer passes_;
    ErrorWatch watch_;
    bool blockIsInFilm_ = true; ///< false: the storage image holds samples that the film lacks
};

} // namespace calotype
