#pragma once

#include <functional>
#include <string>
#include <vector>

#include "settings/bvh_builder.h"
#include "settings/light_choice.h"
#include "settings/render_settings.h"

namespace calotype {

/// The settings that a study varies.
struct StudySettings {
    RenderSettings render;
    LightChoice lightChoice = LightChoice::Power;
    BvhBuilder bvh = BvhBuilder::Sah;
    bool compilesEverything = false; ///< of the kernel, whatever the scene needs
    bool adapts = false;
};

/// One way to render that a study measures: the usual settings with one change.
struct Variant {
    std::string name;        ///< "independent samples"
    std::string options;     ///< of the command line; empty if no option selects this variant
    bool losesLight = false; ///< by design: its picture converges to another one
    std::function<void(StudySettings&)> change;
    bool isOneChange = true; ///< false: it is not combined with others

    StudySettings settings(StudySettings usual) const {
        if (change)
            change(usual);
        return usual;
    }
};

/// The variants of a study: the usual settings first, basic path tracing (independent samples, no
/// roulette, no multiple importance sampling, 4 bounces) last. `usual` are the scene's settings,
/// `mean` is the picture's mean radiance in W/(m^2 sr). With the reference tracer, variants that
/// change the BVH or the kernel are left out.
std::vector<Variant> variantsOf(const StudySettings& usual, double mean, bool isReference = false);

/// One variant with all of these changes.
Variant together(const std::vector<Variant>& variants);

} // namespace calotype
