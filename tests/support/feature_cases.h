#pragma once

#include <cstdint>
#include <functional>
#include <ostream>
#include <span>

#include "support/scene_builder.h"

namespace calotype::test {

/// A floor under a lamp, in 24 x 24 pixels. What tests add stands about the origin.
SceneBuilder litFloor();

using SceneChange = std::function<void(SceneBuilder&)>;

/// What makes the lit floor need a feature of the kernel.
struct FeatureCase {
    uint32_t feature; ///< shared::kFeature...
    const char* name;
    SceneChange change;
    /// Takes the feature from the scene, where a kernel without it would take what it finds there
    /// for something else, and read beyond its buffers.
    std::function<void(Scene&)> removal = {};
};

inline void PrintTo(const FeatureCase& featureCase, std::ostream* stream) {
    *stream << featureCase.name;
}

/// One for every feature of shared/feature_table.h.
std::span<const FeatureCase> featureCases();

} // namespace calotype::test
