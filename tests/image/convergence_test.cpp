// Errors fall with the samples as theory says: as their root for independent ones, and faster for
// Sobol points where the picture is smooth.
#include <cmath>
#include <iostream>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "read/load.h"
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

/// A floor under a lamp that hides no edge in any pixel: smooth in all that is random.
std::string smoothScene(const std::string& lamp) {
    return R"({
  "camera": { "position": [0, 3, 4], "target": [0, 0, 0], "fov": 30 },
  "film": { "width": 16, "height": 16 }, "render": { "max_bounces": 1 },
  "materials": { "grey": { "type": "diffuse", "color": 0.6 } },
  "shapes": [ { "type": "quad", "material": "grey",
                "vertices": [[-20,0,20],[20,0,20],[20,0,-20],[-20,0,-20]] } ],
  "lights": [ )" +
           lamp + " ] }";
}

double slopeOf(const Scene& scene, Sampler sampler) {
    constexpr uint32_t kSeeds = 3;
    constexpr uint32_t kLast = 2048;
    const std::vector<double> truth = render(scene, Sampler::Sobol, 16 * kLast, 99).luminances;
    std::vector<std::pair<double, double>> points;
    for (uint32_t samples = 128; samples <= kLast; samples *= 2) {
        double squares = 0.0;
        for (uint32_t seed = 0; seed < kSeeds; ++seed)
            squares += trueSquare(render(scene, sampler, samples, seed), truth);
        points.emplace_back(samples, std::sqrt(squares / kSeeds));
    }
    const double slope = slopeOf(points);
    std::cout << nameOf(sampler) << ": " << slope << "\n";
    return slope;
}

TEST_F(ConvergenceTest, ErrorsUnderADiskFallAsTheorySays) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("disk.json", smoothScene(R"(
        { "type": "disk", "center": [0, 2, 0], "normal": [0, -1, 0], "radius": 1,
          "radiance": 5 })")));
    EXPECT_NEAR(slopeOf(scene, Sampler::Independent), -0.5, 0.06);
    EXPECT_LT(slopeOf(scene, Sampler::Sobol), -0.65);
}

// A quad is two triangles: the number that chooses one of them also picks the place on it, so that
// each has its half of the points, as evenly spread.
TEST_F(ConvergenceTest, ErrorsUnderAQuadFallFasterThanIndependentOnes) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("quad.json", smoothScene(R"(
        { "type": "quad", "radiance": 5, "vertices": [[-1,2,-1],[1,2,-1],[1,2,1],[-1,2,1]] })")));
    EXPECT_LT(slopeOf(scene, Sampler::Sobol), -0.56);
}

} // namespace
} // namespace calotype::test
