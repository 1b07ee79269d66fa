// Adaptive sampling on the device: the same picture, better spent samples, honest error bars.
#include <cmath>
#include <iostream>
#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "math/luminance.h"
#include "render/adaptive_session.h"
#include "support/device_tracer.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

/// Luminances of one picture, with what it says of their errors.
struct Judged {
    std::vector<double> luminances;
    std::vector<PixelError> errors;
    ErrorEstimate estimate;
};

class AdaptiveTest : public GpuTest {
protected:
    static Judged render(const Scene& scene, uint32_t side, uint32_t samples, uint32_t seed,
                         bool adapts, Sampler sampler = Sampler::Sobol) {
        RenderSettings settings = squareSettings(scene, side, seed);
        settings.samplesPerPixel = samples;
        settings.sampler = sampler;
        DeviceTracer device(scene, settings);
        std::unique_ptr<Session> session;
        if (adapts)
            session = std::make_unique<AdaptiveSession>(device.tracer(), settings,
                                                        device.packed().maxRadiance);
        else
            session = std::make_unique<RenderSession>(device.tracer(), settings,
                                                      device.packed().maxRadiance);
        session->run({});
        Judged judged;
        for (const glm::vec3& pixel : session->picture().pixels)
            judged.luminances.push_back(luminance(glm::dvec3(pixel)));
        judged.errors = session->pixelErrors();
        judged.estimate = *session->error();
        EXPECT_NEAR(static_cast<double>(session->totals().samplesPerPixel), samples,
                    0.05 * samples);
        return judged;
    }

    static double mean(const std::vector<double>& numbers) {
        return std::accumulate(numbers.begin(), numbers.end(), 0.0) /
               static_cast<double>(numbers.size());
    }

    /// ErrorEstimate::relative with the true deviations, of a truth whose own noise is `noise`.
    static double trueError(const Judged& picture, const std::vector<double>& truth, double noise) {
        const double floor = 0.01 * mean(truth);
        double sum = 0.0;
        for (size_t i = 0; i < truth.size(); ++i)
            sum += std::pow(picture.luminances[i] - truth[i], 2.0) /
                   (truth[i] * truth[i] + floor * floor);
        return std::sqrt(
            std::max(0.0, 1.96 * 1.96 * sum / static_cast<double>(truth.size()) - noise * noise));
    }
};

// Noise in a few places: at as many samples the error is smaller, and what is stated is true.
TEST_F(AdaptiveTest, SpendsSamplesBetter) {
    for (const char* path : {"scenes/dielectric.json", "scenes/depth-of-field.json"}) {
        SCOPED_TRACE(path);
        const Scene scene = projectScene(path);
        const Judged truth = render(scene, 32, 8192, 99, false);
        double stated = 0.0;
        double isTrue = 0.0;
        double even = 0.0;
        constexpr uint32_t kSeeds = 3;
        for (uint32_t seed = 0; seed < kSeeds; ++seed) {
            const Judged adaptive = render(scene, 32, 512, seed, true);
            const Judged uniform = render(scene, 32, 512, seed, false);
            const double noise = truth.estimate.relative;
            stated += adaptive.estimate.relative / kSeeds;
            isTrue += trueError(adaptive, truth.luminances, noise) / kSeeds;
            even += trueError(uniform, truth.luminances, noise) / kSeeds;
            EXPECT_TRUE(adaptive.estimate.isTrusted()) << *adaptive.estimate.doubt;
        }
        std::cout << path << ": " << isTrue << " (stated " << stated << "), uniform " << even
                  << "\n";
        EXPECT_NEAR(stated / isTrue, 1.0, 0.12);
        EXPECT_LT(isTrue, 0.85 * even);
    }
}

// 12 pictures of 512 samples: each against the mean of the others, which has an eleventh of its
// variance.
TEST_F(AdaptiveTest, PixelsLieWithinTheirIntervals) {
    constexpr uint32_t kPictures = 12;
    const Scene scene = projectScene("scenes/cornell-box.json");
    for (const Sampler sampler : {Sampler::Independent, Sampler::Sobol}) {
        SCOPED_TRACE(nameOf(sampler));
        std::vector<Judged> pictures;
        for (uint32_t seed = 0; seed < kPictures; ++seed)
            pictures.push_back(render(scene, 16, 512, 300 + seed, true, sampler));
        double within = 0.0;
        double all = 0.0;
        for (size_t i = 0; i < pictures[0].luminances.size(); ++i) {
            double sum = 0.0;
            for (const Judged& picture : pictures)
                sum += picture.luminances[i];
            for (const Judged& picture : pictures) {
                const double others = (sum - picture.luminances[i]) / (kPictures - 1);
                const double interval =
                    picture.errors[i].interval * std::sqrt(1.0 + 1.0 / (kPictures - 1));
                if (interval <= 1e-6 * others)
                    continue;
                within += std::abs(picture.luminances[i] - others) <= interval ? 1.0 : 0.0;
                all += 1.0;
            }
        }
        std::cout << nameOf(sampler) << ": " << within / all << "\n";
        RecordProperty(nameOf(sampler), std::to_string(within / all));
        EXPECT_GT(all, 0.5 * kPictures * 256);
        EXPECT_GT(within / all, 0.93);
        EXPECT_LT(within / all, 0.97);
    }
}

} // namespace
} // namespace calotype::test
