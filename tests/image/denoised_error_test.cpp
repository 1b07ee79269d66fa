// How honest the stated error of denoised pictures is: pictures of many seeds against references.
#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "engine/renderer.h"
#include "film/error_estimate.h"
#include "math/luminance.h"
#include "math/square.h"
#include "support/paths.h"
#include "support/render_scene.h"
#include "support/slow_run.h"
#include "support/statistics.h"
#include "support/test_denoiser.h"

namespace calotype::test {
namespace {

std::vector<double> luminancesOf(const RenderResult& result) {
    std::vector<double> luminances;
    for (size_t i = 0; i < result.pixels.size(); i += 3)
        luminances.push_back(
            luminance(glm::dvec3(result.pixels[i], result.pixels[i + 1], result.pixels[i + 2])));
    return luminances;
}

/// Two independent pictures without denoising. Let a and b be their errors, and e that of another
/// picture. E[(e - a)(e - b)] = E[e^2], so the references need not be without noise.
class Truth {
public:
    Truth(std::vector<double> first, std::vector<double> second)
        : first_(std::move(first)), second_(std::move(second)) {
        for (size_t i = 0; i < first_.size(); ++i)
            mean_ += 0.5 * (first_[i] + second_[i]) / static_cast<double>(first_.size());
    }

    /// Unbiased but for the noise of the denominators: the square of a picture's true error in the
    /// measure of ErrorEstimate::relative.
    double squaredErrorOf(const std::vector<double>& picture) const {
        double sum = 0.0;
        for (size_t i = 0; i < picture.size(); ++i)
            sum += relativeShare((picture[i] - first_[i]) * (picture[i] - second_[i]),
                                 0.5 * (first_[i] + second_[i]), mean_);
        return square(relativeError(1.0)) * sum / static_cast<double>(picture.size());
    }

private:
    std::vector<double> first_;
    std::vector<double> second_;
    double mean_ = 0.0;
};

/// Pictures of one scene, of a square size.
class DenoisedPictures {
public:
    /// With adaptive sampling twice the samples: the first 128 are the same in all pixels.
    DenoisedPictures(const std::string& scene, uint32_t side, DenoiserKind kind, bool isAdaptive)
        : kind_(kind), renderer_(projectScene(scene), options()),
          settings_(renderer_.defaultSettings()) {
        settings_.width = settings_.height = side;
        settings_.samplesPerPixel = isAdaptive ? 256 : 128;
        settings_.isAdaptive = isAdaptive;
        settings_.targetError = {};
        settings_.seconds = {};
    }

    RenderResult denoised(uint32_t seed) {
        settings_.denoiser = kind_;
        settings_.seed = seed;
        return renderer_.render(settings_);
    }

    Truth truth(uint32_t samples) {
        RenderSettings settings = settings_;
        settings.denoiser = DenoiserKind::Off;
        settings.isAdaptive = false;
        settings.samplesPerPixel = samples;
        settings.seed = 1000001;
        std::vector<double> first = luminancesOf(renderer_.render(settings));
        settings.seed = 1000002;
        return {std::move(first), luminancesOf(renderer_.render(settings))};
    }

private:
    static DeviceOptions options() {
        DeviceOptions options;
        const auto library = oidnFile(std::filesystem::path(kProgram).parent_path() / "oidn/lib");
        if (exists(library))
            options.denoiserLibrary = library.string();
        return options;
    }

    DenoiserKind kind_;
    Renderer renderer_;
    RenderSettings settings_;
};

/// Over the pictures of one scene whose error is stated.
struct Honesty {
    std::vector<double> statedSquares;
    std::vector<double> trueSquares;
    uint32_t withinBound = 0;
    uint32_t unstated = 0;

    void add(const RenderResult& picture, const Truth& truth) {
        if (!picture.denoised) {
            ++unstated;
            return;
        }
        statedSquares.push_back(square(picture.denoised->relative));
        trueSquares.push_back(truth.squaredErrorOf(luminancesOf(picture)));
        withinBound += trueSquares.back() <= square(picture.denoised->bound) ? 1 : 0;
    }

    double withinShare() const { return withinBound / static_cast<double>(trueSquares.size()); }
};

// The stated error is that of seven eighths of the samples: up to sqrt(8 / 7) = 1.07 too large.
void expectTrueError(DenoiserKind kind, bool isAdaptive = false) {
    const uint32_t pictures = quickOrFull(isAdaptive ? 4u : 8u, 40u);
    const uint32_t side = quickOrFull(48u, 64u);
    std::vector<std::string> scenes = {"scenes/cornell-box.json"};
    if (isSlowRun())
        scenes.insert(scenes.end(),
                      {"scenes/atelier.json", "scenes/dielectric.json", "scenes/texture.json"});
    for (const std::string& scene : scenes) {
        SCOPED_TRACE(scene);
        DenoisedPictures source(scene, side, kind, isAdaptive);
        const Truth truth = source.truth(quickOrFull(512u, 4096u));
        Honesty honesty;
        for (uint32_t seed = 1; seed <= pictures; ++seed)
            honesty.add(source.denoised(seed), truth);
        ASSERT_GT(honesty.trueSquares.size(), pictures / 2);
        const Estimate stated = estimate(honesty.statedSquares);
        const Estimate actual = estimate(honesty.trueSquares);
        const double ratio = std::sqrt(stated.mean / actual.mean);
        const double standardError =
            0.5 * ratio *
            std::hypot(stated.standardError / stated.mean, actual.standardError / actual.mean);
        std::cout << scene << ": stated " << 100.0 * std::sqrt(stated.mean) << " %, true "
                  << 100.0 * std::sqrt(actual.mean) << " %, ratio " << ratio << " +- "
                  << standardError << ", within the bound " << honesty.withinBound << " of "
                  << honesty.trueSquares.size() << ", not stated " << honesty.unstated << "\n";
        EXPECT_LT(standardError, quickOrFull(0.1, 0.05));
        EXPECT_GT(ratio, 0.85);
        EXPECT_LT(ratio, 1.15);
        EXPECT_GE(honesty.withinShare(), quickOrFull(0.75, 0.9));
    }
}

TEST(DenoisedErrorTest, IsTheTrueError) {
    if (!testDenoiser())
        GTEST_SKIP() << "Open Image Denoise is not installed";
    expectTrueError(DenoiserKind::Oidn);
}
ALSO_SLOW_TEST(DenoisedErrorTest, IsTheTrueError);

TEST(DenoisedErrorTest, IsTheTrueErrorOfTheStatisticalDenoiser) {
    expectTrueError(DenoiserKind::Statistical);
}
ALSO_SLOW_TEST(DenoisedErrorTest, IsTheTrueErrorOfTheStatisticalDenoiser);

// Of pixels with other numbers of samples.
TEST(DenoisedErrorTest, IsTheTrueErrorOfAdaptiveSampling) {
    expectTrueError(DenoiserKind::Statistical, true);
    if (isSlowRun() && testDenoiser())
        expectTrueError(DenoiserKind::Oidn, true);
}
ALSO_SLOW_TEST(DenoisedErrorTest, IsTheTrueErrorOfAdaptiveSampling);

} // namespace
} // namespace calotype::test
