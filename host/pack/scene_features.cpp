#include "pack/scene_features.h"

namespace calotype {

// to_array checks that there are as many names as features.
const std::array<std::string_view, shared::kFeatureCount> kFeatureNames =
    std::to_array<std::string_view>({
#define BEGIN_FEATURES
#define FEATURE(id, people) people,
#define END_FEATURES
#include "shared/feature_table.h"
    });

SceneFeatures SceneFeatures::all() {
    SceneFeatures features;
    features.enabled.fill(true);
    return features;
}

} // namespace calotype
