#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "shared/specialization.h"

namespace calotype {

/// The kernel features that a scene needs, indexed by shared::kFeature...
struct SceneFeatures {
    std::array<bool, shared::kFeatureCount> enabled{};

    /// All features: the kernel for any scene.
    static SceneFeatures all();
};

/// Display names, indexed like SceneFeatures::enabled.
extern const std::array<std::string_view, shared::kFeatureCount> kFeatureNames;

} // namespace calotype
