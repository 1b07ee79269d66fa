// Errors fall with the samples as theory says: as their root for independent ones, and faster for
// Sobol points where the picture is smooth.
#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "read/load.h"
#include "render/render_session.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/judged_picture.h"
#include "support/program.h"
#include "support/slow_run.h"

namespace calotype::test {
namespace {

using ConvergenceTest = GpuTest;

constexpr uint32_t kLast = 2048; ///< samples of a pixel

RenderSettings settingsOf(const Scene& scene, Sampler sampler, uint32_t samples, uint32_t seed) {
    RenderSettings settings = squareSettings(scene, 16, seed);
    settings.sampler = sampler;
    settings.samplesPerPixel = samples;
    return settings;
}

// A square of its errors is about a twentieth of those of kLast of Sobol's points, and a fortieth
// in the slow run, which makes the slopes less steep by less than 0.01.
std::vector<double> truthOf(const Scene& scene) {
    const RenderSettings settings =
        settingsOf(scene, Sampler::Sobol, quickOrFull(8u, 16u) * kLast, 99);
    DeviceTracer device(scene, settings);
    RenderSession session(device.tracer(), settings, device.packed().maxRadiance);
    session.run({});
    return judge(session.film()).luminances;
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

/// Of one film for each seed, while it grows.
double slopeOf(const Scene& scene, Sampler sampler, const std::vector<double>& truth) {
    constexpr uint32_t kSeeds = 3;
    std::map<uint32_t, double> squares;
    for (uint32_t seed = 0; seed < kSeeds; ++seed) {
        RenderSettings settings = settingsOf(scene, sampler, 0, seed);
        DeviceTracer device(scene, settings);
        std::optional<Film> film;
        for (uint32_t samples = 128; samples <= kLast; samples *= 2) {
            settings.samplesPerPixel = samples;
            auto session =
                film ? RenderSession(device.tracer(), settings, *film)
                     : RenderSession(device.tracer(), settings, device.packed().maxRadiance);
            session.run({});
            film = session.film();
            squares[samples] += trueSquare(judge(*film), truth) / kSeeds;
        }
    }
    std::vector<std::pair<double, double>> points;
    for (const auto& [samples, square] : squares)
        points.emplace_back(samples, std::sqrt(square));
    const double slope = slopeOf(points);
    std::cout << nameOf(sampler) << ": " << slope << "\n";
    return slope;
}

TEST_F(ConvergenceTest, ErrorsUnderADiskFallAsTheorySays) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("disk.json", smoothScene(R"(
        { "type": "disk", "center": [0, 2, 0], "normal": [0, -1, 0], "radius": 1,
          "radiance": 5 })")));
    const std::vector<double> truth = truthOf(scene);
    EXPECT_NEAR(slopeOf(scene, Sampler::Independent, truth), -0.5, 0.06);
    EXPECT_LT(slopeOf(scene, Sampler::Sobol, truth), -0.65);
}
ALSO_SLOW(ConvergenceTest, ErrorsUnderADiskFallAsTheorySays);

// A quad is two triangles: the number that chooses one of them also picks the place on it, so that
// each has its half of the points, as evenly spread.
TEST_F(ConvergenceTest, ErrorsUnderAQuadFallFasterThanIndependentOnes) {
    const TestFolder folder;
    const Scene scene = loadScene(folder.write("quad.json", smoothScene(R"(
        { "type": "quad", "radiance": 5, "vertices": [[-1,2,-1],[1,2,-1],[1,2,1],[-1,2,1]] })")));
    EXPECT_LT(slopeOf(scene, Sampler::Sobol, truthOf(scene)), -0.56);
}
ALSO_SLOW(ConvergenceTest, ErrorsUnderAQuadFallFasterThanIndependentOnes);

} // namespace
} // namespace calotype::test
