#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "shared/specialization.h"

namespace calotype {

/// Which features of the kernel a scene needs, indexed by shared::kFeature...
struct SceneFeatures {
    std::array<bool, shared::kFeatureCount> enabled{};

    /// Everything compiled in: the kernel for any scene.
    static SceneFeatures all();
};

/// Names for people, indexed like SceneFeatures::enabled.
extern const std::array<std::string_view, shared::kFeatureCount> kFeatureNames;

} // namespace calotype
