// How honest the stated error is: pictures of many seeds against each other.
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "film/error_estimate.h"
#include "math/luminance.h"
#include "support/gpu_test.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

/// Luminances of one picture, with what it says of their errors.
struct Judged {
    std::vector<double> luminances;
    std::vector<PixelError> errors;
    ErrorEstimate estimate;
    uint64_t samples = 0;
};

class ErrorBarsTest : public GpuTest {
protected:
    static RenderWish wishFor(Sampler sampler, uint32_t side, uint32_t samples, uint32_t seed) {
        RenderWish wish;
        wish.width = wish.height = side;
        wish.samplesPerPixel = samples;
        wish.sampler = sampler;
        wish.seed = seed;
        return wish;
    }

    static Judged judge(const Scene& scene, const RenderWish& wish) {
        const RenderedScene rendered = renderScene(scene, wish);
        Judged judged;
        for (const glm::vec3& pixel : rendered.film.picture().pixels)
            judged.luminances.push_back(luminance(glm::dvec3(pixel)));
        judged.errors = pixelErrors(rendered.film);
        judged.estimate = *estimateError(rendered.film);
        judged.samples = rendered.film.samplesPerPixel();
        return judged;
    }

    static std::vector<double> meanOf(const std::vector<Judged>& pictures) {
        std::vector<double> mean(pictures[0].luminances.size());
        for (const Judged& picture : pictures)
            for (size_t i = 0; i < mean.size(); ++i)
                mean[i] += picture.luminances[i] / static_cast<double>(pictures.size());
        return mean;
    }

    /// Counts pixels whose error lies within what is stated. Those without noise are not counted.
    struct Coverage {
        double within = 0.0;
        double all = 0.0;

        /// `noise` is the truth's own variance, as a share of the picture's.
        void add(const Judged& picture, const std::vector<double>& truth, double noise) {
            for (size_t i = 0; i < truth.size(); ++i) {
                const double distance = std::abs(picture.luminances[i] - truth[i]);
                const double interval = picture.errors[i].interval;
                if (interval <= 1e-6 * truth[i])
                    continue;
                within += distance <= interval * std::sqrt(1.0 + noise) ? 1.0 : 0.0;
                all += 1.0;
            }
        }

        double share() const { return within / all; }
    };
};

constexpr const char* kSmoothScenes[] = {"scenes/cornell-box.json", "scenes/sphere.json",
                                         "scenes/background.json"};

// 12 pictures of 512 samples: each against the mean of the others, which has an eleventh of its
// variance.
TEST_F(ErrorBarsTest, PixelsLieWithinTheirIntervals) {
    constexpr uint32_t kPictures = 12;
    for (const Sampler sampler : {Sampler::Independent, Sampler::Sobol})
        for (const char* path : kSmoothScenes) {
            SCOPED_TRACE(std::string(path) + ", " + nameOf(sampler));
            const Scene scene = projectScene(path);
            std::vector<Judged> pictures;
            for (uint32_t seed = 0; seed < kPictures; ++seed)
                pictures.push_back(judge(scene, wishFor(sampler, 16, 512, 500 + seed)));
            const std::vector<double> mean = meanOf(pictures);
            Coverage coverage;
            double squares = 0.0; // of the true relative errors
            double stated = 0.0;
            double brightness = 0.0;
            for (const double l : mean)
                brightness += l / static_cast<double>(mean.size());
            for (const Judged& picture : pictures) {
                std::vector<double> others(mean.size());
                for (size_t i = 0; i < mean.size(); ++i) {
                    others[i] = (mean[i] * kPictures - picture.luminances[i]) / (kPictures - 1);
                    const double floor = 0.01 * brightness;
                    squares += std::pow(picture.luminances[i] - mean[i], 2.0) /
                               (mean[i] * mean[i] + floor * floor);
                }
                coverage.add(picture, others, 1.0 / (kPictures - 1));
                stated += picture.estimate.relative / kPictures;
                EXPECT_TRUE(picture.estimate.isTrusted()) << *picture.estimate.doubt;
            }
            RecordProperty(nameOf(sampler) + std::string(path), std::to_string(coverage.share()));
            EXPECT_GT(coverage.all, 0.5 * kPictures * static_cast<double>(mean.size()));
            EXPECT_GT(coverage.share(), 0.93);
            EXPECT_LT(coverage.share(), 0.97);
            // The picture's one number, against what it estimates.
            const double truth =
                1.96 * std::sqrt(squares / static_cast<double>(mean.size() * (kPictures - 1)));
            EXPECT_NEAR(stated / truth, 1.0, 0.1);
        }
}

// Few pixels, so that chance decides when the error seems good enough: that must not spoil it.
TEST_F(ErrorBarsTest, PixelsLieWithinTheirIntervalsWhereTheErrorEndedTheRender) {
    constexpr uint32_t kPictures = 32;
    constexpr uint32_t kReference = 1u << 15;
    const Scene scene = projectScene("scenes/cornell-box.json");
    for (const auto& [sampler, target] :
         {std::pair{Sampler::Independent, 0.14}, {Sampler::Sobol, 0.092}}) {
        SCOPED_TRACE(nameOf(sampler));
        const Judged reference = judge(scene, wishFor(sampler, 8, kReference, 77));
        Coverage coverage;
        std::map<uint64_t, uint32_t> endings;
        for (uint32_t seed = 0; seed < kPictures; ++seed) {
            RenderWish wish = wishFor(sampler, 8, 1u << 13, 1000 + seed);
            wish.goal.targetError = target;
            const Judged picture = judge(scene, wish);
            ++endings[picture.samples];
            coverage.add(picture, reference.luminances,
                         static_cast<double>(picture.samples) / kReference);
        }
        for (const auto& [samples, count] : endings)
            std::cout << nameOf(sampler) << ": " << count << " ended at " << samples << "\n";
        RecordProperty(nameOf(sampler), std::to_string(coverage.share()));
        EXPECT_GE(endings.begin()->first, 512u);
        EXPECT_GE(endings.size(), 2u) << "chance has to have a say";
        EXPECT_GT(coverage.share(), 0.93);
        EXPECT_LT(coverage.share(), 0.97);
    }
}

} // namespace
} // namespace calotype::test
