// Errors fall with the samples as theory says: as their root for independent ones, and faster for
// Sobol points where the picture is smooth.
#include <cmath>
#include <iostream>
#include <span>
#include <utility>
#include <vector>

#include "scene/load.h"
#include "support/gpu_test.h"
#include "support/judged_picture.h"
#include "support/program.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

using ConvergenceTest = GpuTest;

JudgedPicture render(const Scene& scene, Sampler sampler, uint32_t samples, uint32_t seed) {
    RenderWish wish;
    wish.width = wish.height = 16;
    wish.samplesPerPixel = samples;
    wish.sampler = sampler;
    wish.seed = seed;
    return judge(renderScene(scene, wish).film);
}

/// Of the straight line through the logarithms.
double slopeOf(std::span<const std::pair<double, double>> points) {
    double x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
    const auto count = static_cast<double>(points.size());
    for (const auto& [samples, error] : points) {
        x += std::log(samples) / count;
        y += std::log(error) / count;
    }
    for (const auto& [samples, error] : points) {
        xx += std::pow(std::log(samples) - x, 2.0);
        xy += (std::log(samples) - x) * (std::log(error) - y);
    }
    return xy / xx;
}

/// A floor under a disk lamp that hides no edge in any pixel: smooth in all that is random.
constexpr const char* kSmoothScene = R"({
  "camera": { "position": [0, 3, 4], "target": [0, 0, 0], "fov": 30 },
  "film": { "width": 16, "height": 16 }, "render": { "max_bounces": 1 },
  "materials": { "grey": { "type": "diffuse", "color": 0.6 } },
  "shapes": [ { "type": "quad", "material": "grey",
                "vertices": [[-20,0,20],[20,0,20],[20,0,-20],[-20,0,-20]] } ],
  "lights": [ { "type": "disk", "center": [0, 2, 0], "normal": [0, -1, 0], "radius": 1,
                "radiance": 5 } ]
})";

TEST_F(ConvergenceTest, ErrorsFallAsTheorySays) {
    constexpr uint32_t kSeeds = 3;
    constexpr uint32_t kLast = 2048;
    const ScratchFolder folder;
    const Scene scene = loadScene(folder.write("smooth.json", kSmoothScene));
    const std::vector<double> truth = render(scene, Sampler::Sobol, 16 * kLast, 99).luminances;
    for (const Sampler sampler : {Sampler::Independent, Sampler::Sobol}) {
        std::vector<std::pair<double, double>> points;
        for (uint32_t samples = 128; samples <= kLast; samples *= 2) {
            double squares = 0.0;
            for (uint32_t seed = 0; seed < kSeeds; ++seed)
                squares += trueSquare(render(scene, sampler, samples, seed), truth);
            points.emplace_back(samples, std::sqrt(squares / kSeeds));
        }
        const double slope = slopeOf(points);
        std::cout << nameOf(sampler) << ": " << slope << "\n";
        if (sampler == Sampler::Independent)
            EXPECT_NEAR(slope, -0.5, 0.06);
        else
            EXPECT_LT(slope, -0.65);
    }
}

} // namespace
} // namespace calotype::test
