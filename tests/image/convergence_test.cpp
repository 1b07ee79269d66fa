// Errors fall with the samples as theory says: as their root for independent ones, and faster for
// Sobol points where the picture is smooth.
#include <cmath>
#include <iostream>
#include <span>
#include <utility>
#include <vector>

#include "math/luminance.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

using ConvergenceTest = GpuTest;

std::vector<double> luminances(const Scene& scene, Sampler sampler, uint32_t samples,
                               uint32_t seed) {
    RenderWish wish;
    wish.width = wish.height = 16;
    wish.samplesPerPixel = samples;
    wish.sampler = sampler;
    wish.seed = seed;
    std::vector<double> numbers;
    for (const glm::vec3& pixel : renderScene(scene, wish).image.pixels)
        numbers.push_back(luminance(glm::dvec3(pixel)));
    return numbers;
}

double errorOf(const std::vector<double>& picture, const std::vector<double>& truth) {
    double mean = 0.0;
    for (const double l : truth)
        mean += l / static_cast<double>(truth.size());
    double sum = 0.0;
    for (size_t i = 0; i < truth.size(); ++i)
        sum += std::pow(picture[i] - truth[i], 2.0) / (truth[i] * truth[i] + 1e-4 * mean * mean);
    return std::sqrt(sum / static_cast<double>(truth.size()));
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

TEST_F(ConvergenceTest, ErrorsFallAsTheorySays) {
    constexpr uint32_t kSeeds = 3;
    constexpr uint32_t kLast = 2048;
    for (const char* path : {"scenes/background.json", "scenes/sphere.json"}) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        const std::vector<double> truth = luminances(scene, Sampler::Sobol, 16 * kLast, 99);
        for (const Sampler sampler : {Sampler::Independent, Sampler::Sobol}) {
            std::vector<std::pair<double, double>> points;
            for (uint32_t samples = 128; samples <= kLast; samples *= 2) {
                double squares = 0.0;
                for (uint32_t seed = 0; seed < kSeeds; ++seed)
                    squares +=
                        std::pow(errorOf(luminances(scene, sampler, samples, seed), truth), 2.0);
                points.emplace_back(samples, std::sqrt(squares / kSeeds));
            }
            const double slope = slopeOf(points);
            std::cout << path << ", " << nameOf(sampler) << ": " << slope << "\n";
            if (sampler == Sampler::Independent)
                EXPECT_NEAR(slope, -0.5, 0.06);
            else
                EXPECT_LT(slope, -0.6);
        }
    }
}

} // namespace
} // namespace calotype::test
