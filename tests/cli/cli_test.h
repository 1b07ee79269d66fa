#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support/program.h"

namespace calotype::test {

/// A small valid scene: a floor, a sphere and a light, 32 x 24 pixels.
inline const std::string kSmallScene = R"({
  "camera": { "position": [0, 1, 4], "target": [0, 0.5, 0], "fov": 40 },
  "film": { "width": 32, "height": 24 },
  "render": { "spp": 4, "max_bounces": 2 },
  "materials": { "grey": { "type": "diffuse", "color": 0.6 } },
  "shapes": [
    { "type": "quad", "vertices": [[-3,0,3],[3,0,3],[3,0,-3],[-3,0,-3]], "material": "grey" },
    { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": "grey" }
  ],
  "lights": [
    { "type": "disk", "center": [0, 3, 1], "normal": [0, -1, 0], "radius": 0.5, "radiance": 20 }
  ]
})";

class CliTest : public testing::Test {
protected:
    TestFolder folder_;
    std::string scene_ = folder_.write("scene.json", kSmallScene);
};

/// Expects the exit code, and one line on standard error that contains `fragment`.
inline void expectFailure(const ProgramResult& result, int exitCode, const std::string& fragment) {
    EXPECT_EQ(result.exitCode, exitCode) << result.errors;
    EXPECT_NE(result.errors.find(fragment), std::string::npos) << result.errors;
    EXPECT_EQ(std::count(result.errors.begin(), result.errors.end(), '\n'), 1) << result.errors;
    EXPECT_EQ(result.errors.rfind("calotype: ", 0), 0u) << result.errors;
}

} // namespace calotype::test
