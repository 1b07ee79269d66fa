#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "cli/options.h"
#include "render/session.h"

namespace calotype {

/// What a render came to.
struct RenderReport {
    const RenderOptions& options;
    const RenderTotals& totals;
    RenderEnding ending;
    std::optional<uint64_t> samplesWanted; ///< per pixel; none: as many as it takes
    std::string film;                      ///< its path, or empty
    uint64_t cutPixels = 0;                ///< of the layers of first hits
};

/// Says on standard error what is wrong with the picture, if anything, and how it ended.
void reportRender(const RenderReport& report);

} // namespace calotype
