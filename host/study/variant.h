#pragma once

#include <functional>
#include <string>
#include <vector>

#include "settings/render_settings.h"

namespace calotype {

/// One way to render that a study measures: the usual settings with one change.
struct Variant {
    std::string name;        ///< "independent samples"
    std::string options;     ///< of the command line; empty if no option selects this variant
    bool losesLight = false; ///< by design: its picture converges to another one
    std::function<void(RenderSettings&)> change;
    bool isOneChange = true; ///< false: it is not combined with others
    bool isDenoised = false;

    RenderSettings settings(RenderSettings usual) const {
        if (change)
            change(usual);
        return usual;
    }
};

/// The variants of a study: the usual settings first, basic path tracing (independent samples, no
/// roulette, no multiple importance sampling, 4 bounces) last. `usual` are the scene's settings,
/// `mean` is the picture's mean radiance in W/(m^2 sr). With the reference tracer, variants that
/// change the BVH or the kernel are left out.
std::vector<Variant> variantsOf(const RenderSettings& usual, double mean, bool isReference = false);

/// The usual settings and a denoiser.
Variant denoisedVariant(const RenderSettings& usual, DenoiserKind denoiser);

/// One variant with all of these changes.
Variant together(const RenderSettings& usual, const std::vector<Variant>& variants);

} // namespace calotype
