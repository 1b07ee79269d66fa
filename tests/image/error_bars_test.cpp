// How honest the stated error is: pictures of many seeds against each other.
#include <cmath>
#include <iostream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "support/gpu_test.h"
#include "support/judged_picture.h"
#include "support/render_scene.h"

namespace calotype::test {
namespace {

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
            std::vector<JudgedPicture> pictures;
            for (uint32_t seed = 0; seed < kPictures; ++seed)
                pictures.push_back(
                    judge(renderScene(scene, wishFor(sampler, 16, 512, 500 + seed)).film));
            const std::vector<double> truth = meanOfOthers(pictures);
            Coverage coverage;
            double squares = 0.0; // of the true relative errors
            double stated = 0.0;
            for (const JudgedPicture& picture : pictures) {
                squares += trueSquare(picture, truth) / (kPictures - 1);
                coverage.add(picture, meanOfOthers(pictures, &picture), 1.0 / (kPictures - 1));
                stated += picture.estimate.relative / kPictures;
                EXPECT_TRUE(picture.estimate.isTrusted()) << *picture.estimate.doubt;
            }
            RecordProperty(nameOf(sampler) + std::string(path), std::to_string(coverage.share()));
            EXPECT_GT(coverage.all, 0.5 * kPictures * static_cast<double>(truth.size()));
            EXPECT_GT(coverage.share(), 0.93);
            EXPECT_LT(coverage.share(), 0.97);
            // The picture's one number, against what it estimates.
            EXPECT_NEAR(stated / (1.96 * std::sqrt(squares)), 1.0, 0.1);
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
        const JudgedPicture reference =
            judge(renderScene(scene, wishFor(sampler, 8, kReference, 77)).film);
        Coverage coverage;
        std::map<uint64_t, uint32_t> endings;
        for (uint32_t seed = 0; seed < kPictures; ++seed) {
            RenderWish wish = wishFor(sampler, 8, 1u << 13, 1000 + seed);
            wish.goal.targetError = target;
            const Film film = renderScene(scene, wish).film;
            ++endings[film.samplesPerPixel()];
            coverage.add(judge(film), reference.luminances,
                         static_cast<double>(film.samplesPerPixel()) / kReference);
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
