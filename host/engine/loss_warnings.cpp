#include "engine/loss_warnings.h"

namespace calotype {

std::vector<std::string> lossWarnings(const FilmLosses& losses, uint64_t cutPixels,
                                      uint64_t cutFeatureRays) {
    std::vector<std::string> warnings;
    const auto warn = [&](uint64_t count, const char* text) {
        if (count > 0)
            warnings.push_back(std::to_string(count) + " " + text);
    };
    warn(losses.nonFiniteSamples, "samples were not finite and count as black");
    warn(losses.cutPaths, "paths were cut short by the device's loop limit, so the picture is "
                          "too dark; lower --max-bounces, use fewer transparent layers, or take a "
                          "GPU");
    warn(cutPixels, "pixels lie behind more transparent surfaces than the layers of --aov see "
                    "through, and show one of those as if it were opaque");
    warn(cutFeatureRays,
         "rays of the averaged layers (of --aov and for denoising) were cut short by "
         "the device's loop limit behind too many transparent or mirroring surfaces, and show "
         "one of those as if it were opaque, or nothing");
    warn(losses.lostPixels(), "blocks of samples were too bright for the film and count as black");
    return warnings;
}

} // namespace calotype
