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
#include "support/seeded_films.h"
#include "support/slow_run.h"
#include "support/statistics.h"

namespace calotype::test {
namespace {

class ErrorBarsTest : public GpuTest {
protected:
    static RenderSettings settingsOf(const Scene& scene, Sampler sampler, uint32_t side,
                                     uint32_t samples) {
        RenderSettings settings = squareSettings(scene, side, 500);
        settings.sampler = sampler;
        settings.samplesPerPixel = samples;
        return settings;
    }
};

constexpr const char* kSmoothScenes[] = {"scenes/cornell-box.json", "scenes/sphere.json",
                                         "scenes/background.json"};

// Pictures of 512 samples: each against the mean of the others, which has at most an eleventh of
// its variance.
TEST_F(ErrorBarsTest, PixelsLieWithinTheirIntervals) {
    const uint32_t pictureCount = quickOrFull(12u, 48u);
    for (const Sampler sampler : {Sampler::Independent, Sampler::Sobol})
        for (const char* path : kSmoothScenes) {
            SCOPED_TRACE(std::string(path) + ", " + nameOf(sampler));
            const Scene scene = projectScene(path);
            std::vector<JudgedPicture> pictures;
            SeededFilms films(scene, settingsOf(scene, sampler, 16, 512));
            for (uint32_t i = 0; i < pictureCount; ++i)
                pictures.push_back(judge(films.next<RenderSession>()));
            const std::vector<double> truth = meanOfOthers(pictures);
            Coverage coverage;
            std::vector<double> squares; // of the true relative errors
            std::vector<double> statements;
            for (const JudgedPicture& picture : pictures) {
                squares.push_back(trueSquare(picture, truth) * pictureCount / (pictureCount - 1));
                coverage.add(picture, meanOfOthers(pictures, &picture), 1.0 / (pictureCount - 1));
                statements.push_back(picture.estimate.relative);
                EXPECT_TRUE(picture.estimate.isTrusted()) << *picture.estimate.doubt;
            }
            RecordProperty(nameOf(sampler) + std::string(path), std::to_string(coverage.share()));
            EXPECT_GT(coverage.all, 0.5 * pictureCount * static_cast<double>(truth.size()));
            EXPECT_GT(coverage.share(), 0.93);
            EXPECT_LT(coverage.share(), 0.97);
            // The picture's one number, against what it estimates: within five standard errors of
            // their ratio, a hundredth to a tenth by the scene. A picture of large errors states
            // large ones: the two are correlated, so the ratio's true error is smaller.
            const Estimate square = estimate(squares);
            const Estimate stated = estimate(statements);
            const double ratio = stated.mean / (1.96 * std::sqrt(square.mean));
            const double standardError =
                ratio * std::hypot(stated.standardError / stated.mean,
                                   0.5 * square.standardError / square.mean);
            std::cout << path << ", " << nameOf(sampler) << ": stated " << ratio << " +- "
                      << standardError << " of the error, " << coverage.share() << " within\n";
            EXPECT_NEAR(ratio, 1.0, 5.0 * standardError);
            EXPECT_LT(standardError, quickOrFull(0.15, 0.05));
        }
}
ALSO_SLOW(ErrorBarsTest, PixelsLieWithinTheirIntervals);

// Few pixels, so that chance decides when the error seems good enough: that must not spoil it.
TEST_F(ErrorBarsTest, PixelsLieWithinTheirIntervalsWhereTheErrorEndedTheRender) {
    constexpr uint32_t kPictures = 32;
    constexpr uint32_t kReference = 1u << 15;
    const Scene scene = projectScene("scenes/cornell-box.json");
    for (const auto& [sampler, target] :
         {std::pair{Sampler::Independent, 0.14}, {Sampler::Sobol, 0.092}}) {
        SCOPED_TRACE(nameOf(sampler));
        SeededFilms films(scene, settingsOf(scene, sampler, 8, kReference));
        const JudgedPicture reference = judge(films.next<RenderSession>());
        Coverage coverage;
        std::map<uint64_t, uint32_t> endings;
        RenderGoal goal;
        goal.targetError = target;
        for (uint32_t i = 0; i < kPictures; ++i) {
            const Film film = films.next<RenderSession>(1u << 13, goal);
            ++endings[film.samplesPerPixel()];
            coverage.add(judge(film), reference.luminances,
                         static_cast<double>(film.samplesPerPixel()) / kReference);
        }
        for (const auto& [samples, count] : endings)
            std::cout << nameOf(sampler) << ": " << count << " ended at " << samples << "\n";
        RecordProperty(nameOf(sampler), std::to_string(coverage.share()));
        EXPECT_GT(endings.begin()->first, 128u) << "the first look";
        EXPECT_GE(endings.size(), 2u) << "chance has to have a say";
        EXPECT_GT(coverage.share(), 0.93);
        EXPECT_LT(coverage.share(), 0.97);
    }
}

} // namespace
} // namespace calotype::test
