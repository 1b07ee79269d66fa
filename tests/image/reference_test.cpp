// Against a picture of another renderer, where the test data is at hand.
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <string>

#include "image/difference.h"
#include "image/exr.h"
#include "support/gpu_test.h"
#include "support/image_means.h"
#include "support/paths.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

class ReferenceTest : public GpuTest {};

// B. Bitterli's Cornell box, rendered by Tungsten with 64 bounces. The bounds are those for 1024
// samples; 64 keep within them and leave time for the other tests.
TEST_F(ReferenceTest, BitterliCornellBox) {
    const std::filesystem::path reference =
        std::filesystem::path(kProjectFolder) /
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
    const double relativeMse = measureDifference(seen, expected).relativeMse;
    EXPECT_LT(relativeMse, 0.005);
    std::cout << "mean over the reference's: " << ratio.x << " " << ratio.y << " " << ratio.z
              << ", relative MSE " << relativeMse << "\n";
}

// B. Bitterli's Veach scene, rendered by Tungsten with direct light only. Its plates are left out:
// nothing else has colour, and Beckmann's distribution is none of ours (tests/image/README.md).
// What is left are diffuse walls, lit by spheres whose areas differ 400-fold, and the spheres
// themselves.
TEST_F(ReferenceTest, BitterliVeachMisButForItsPlates) {
    const std::filesystem::path reference = std::filesystem::path(kProjectFolder) /
                                            "../shared/data/bitterli-veach-mis/TungstenRender.exr";
    if (!std::filesystem::exists(reference))
        GTEST_SKIP() << "there is no " << reference;
    const Scene scene = projectScene("tests/image/scenes/bitterli-veach-mis.json");
    RenderWish wish;
    wish.width = 320;
    wish.height = 180;
    wish.samplesPerPixel = 64;
    const Image seen = renderScene(scene, wish).image;
    const Image expected = boxDownsample(readExr(reference), 4);

    struct Part {
        double seen = 0.0;
        double expected = 0.0;
        double ratio() const { return seen / expected; }
    } room, lamps;
    int platePixels = 0;
    for (size_t i = 0; i < seen.pixels.size(); ++i) {
        const glm::vec3& pixel = seen.pixels[i];
        if (pixel.x != pixel.z) {
            ++platePixels;
            continue;
        }
        Part& part = expected.pixels[i].y > 1.0f ? lamps : room;
        part.seen += pixel.y;
        part.expected += expected.pixels[i].y;
    }
    // If colours were wrong everywhere, nothing would be compared: the plates fill a sixth of the
    // picture.
    EXPECT_LT(platePixels, 14000);
    EXPECT_NEAR(room.ratio(), 1.0, 0.002);
    // The small lamp is 5 pixels large, so that samples along its rim decide a hundredth.
    EXPECT_NEAR(lamps.ratio(), 1.0, 0.02);
    std::cout << "mean over the reference's: room " << room.ratio() << ", lamps " << lamps.ratio()
              << ", apart from " << platePixels << " pixels of the plates\n";
}

} // namespace
} // namespace calotype::test
