#include "engine/scene_settings.h"

#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "support/scene_builder.h"

namespace calotype::test {
namespace {

/// A polygon of so many triangles, which emit.
Scene lampOf(uint32_t triangles) {
    SceneBuilder builder;
    std::vector<glm::dvec3> corners;
    for (uint32_t i = 0; i < triangles + 2; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / (triangles + 2);
        corners.emplace_back(std::cos(angle), std::sin(angle), 0.0);
    }
    builder.polygon(corners, builder.material(0.0, 1.0));
    return builder.scene();
}

TEST(DefaultSettingsTest, ChooseManyLightsByATree) {
    EXPECT_EQ(defaultSettings(lampOf(16)).transport.lightChoice, LightChoice::Power);
    EXPECT_EQ(defaultSettings(lampOf(17)).transport.lightChoice, LightChoice::Tree);
}

} // namespace
} // namespace calotype::test
