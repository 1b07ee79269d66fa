#pragma once

#include <functional>
#include <string>
#include <vector>

#include "settings/bvh_builder.h"
#include "settings/light_choice.h"
#include "settings/render_settings.h"

namespace calotype {

/// All that a study may choose for a render.
struct StudySettings {
    RenderSettings render;
    LightChoice lightChoice = LightChoice::Power;
    BvhBuilder bvh = BvhBuilder::Sah;
    bool compilesEverything = false; ///< of the kernel, whatever the scene needs
    bool adapts = false;
};

/// One way to render that a study tries: the usual settings but for a change.
struct Variant {
    std::string name;        ///< "independent samples"
    std::string options;     ///< of the command line; empty where it has none
    bool losesLight = false; ///< by design: its picture tends to another one
    std::function<void(StudySettings&)> change;
    bool isOneChange = true; ///< else it is not tried together with others

    StudySettings settings(StudySettings usual) const {
        if (change)
            change(usual);
        return usual;
    }
};

/// What a study tries, the usual settings first, the report's last. `usual` are of the scene, and
/// `mean` is the picture's mean radiance, W/(m^2 sr). The reference tracer has no choice of tree
/// and kernel.
std::vector<Variant> variantsOf(const StudySettings& usual, double mean, bool isReference = false);

/// All of these changes at once.
Variant together(const std::vector<Variant>& variants);

} // namespace calotype
