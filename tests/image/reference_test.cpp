// Against a picture of another renderer, where the test data is at hand.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "image/exr.h"
#include "image/metrics.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

class ReferenceTest : public GpuTest {};

// B. Bitterli's Cornell box, rendered by Tungsten with 64 bounces. The bounds are those for 1024
// samples; 64 keep within them and leave time for the other tests.
TEST_F(ReferenceTest, BitterliCornellBox) {
    const std::filesystem::path reference =
        std::filesystem::path(CALOTYPE_SOURCE_DIR) /
        "../shared/data/bitterli-cornell-box/TungstenRender.exr";
    const Scene scene = projectScene("tests/image/scenes/bitterli-cornell-box.json");
    RenderWish wish;
    const char* samples = std::getenv("CALOTYPE_REFERENCE_SPP");
    wish.samplesPerPixel = samples ? std::stoul(samples) : 64;
    if (!std::filesystem::exists(reference)) { // then at least a dim and noisy picture of it
        wish.samplesPerPixel = 4;
        const glm::dvec3 mean = imageMean(renderScene(scene, wish).image);
        EXPECT_NEAR(mean.x / mean.z, 5.4, 0.3);
        return;
    }
    const Image seen = boxDownsample(renderScene(scene, wish).image, 2);
    const Image expected = boxDownsample(readExr(reference), 8);
    const glm::dvec3 ratio = imageMean(seen) / imageMean(expected);
    EXPECT_NEAR(ratio.x, 1.0, 0.01);
    EXPECT_NEAR(ratio.y, 1.0, 0.01);
    EXPECT_NEAR(ratio.z, 1.0, 0.01);
    EXPECT_LT(relativeMse(seen, expected), 0.005);
    std::cout << "mean over the reference's: " << ratio.x << " " << ratio.y << " " << ratio.z
              << ", relative MSE " << relativeMse(seen, expected) << "\n";
}

} // namespace
} // namespace calotype::test
