#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "cli/options.h"
#include "image/first_hit.h"
#include "image/pixel_error.h"
#include "render/render_session.h"

namespace calotype {

/// Writes a render's pictures, in the end and on the way.
class PictureWriter {
public:
    PictureWriter(const RenderOptions& options, const RenderSettings& settings, uint64_t sceneHash)
        : options_(options), settings_(settings), sceneHash_(sceneHash) {}

    /// What the layers of first hits show; needed before any picture where they are wanted.
    void setFirstHits(FirstHitImage hits) { firstHits_ = std::move(hits); }

    /// Writes every output that can be written, then throws what went wrong first, if anything.
    void writeOutputs(RenderSession& session) const;

    /// A picture that cannot be written is warned of: the render is worth more than a preview of
    /// it.
    void writePreview(RenderSession& session) const;

private:
    /// Of one moment.
    struct Contents {
        Image picture;
        std::vector<PixelError> errors;
        RenderTotals totals;
    };

    Contents contentsOf(RenderSession& session) const;
    void write(const std::string& path, const Contents& contents) const;

    const RenderOptions& options_;
    const RenderSettings& settings_;
    uint64_t sceneHash_;
    FirstHitImage firstHits_; ///< empty where no layer is wanted
};

} // namespace calotype
