// The curve of a denoised variant: which points it has, and what their times include.
#include "study/denoised_curve.h"

#include <chrono>
#include <functional>
#include <random>
#include <span>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "render/render_session.h"

namespace calotype::test {
namespace {

constexpr uint32_t kSide = 16;
constexpr double kFeatureSeconds = 100.0;

/// Samples from 0 to 2, of a seed.
class UniformTracer : public BlockTracer {
public:
    explicit UniformTracer(uint32_t seed) : random_(seed) {}

    uint32_t tileCount() const override { return 1; }
    void beginBlock(uint32_t, std::span<const uint8_t>) override {
        sums_.assign(kSide * kSide, glm::vec4(0.0f));
    }
    shared::RenderCounters renderTiles(TileRange, uint32_t sampleEnd) override {
        std::uniform_real_distribution<float> light(0.0f, 2.0f);
        for (glm::vec4& sum : sums_)
            while (sum.w < static_cast<float>(sampleEnd))
                sum += glm::vec4(glm::vec3(light(random_)), 1.0f);
        return {};
    }
    std::span<const glm::vec4> readBlock() override { return sums_; }

private:
    std::mt19937 random_;
    std::vector<glm::vec4> sums_;
};

class DenoisedCurveTest : public testing::Test {
protected:
    static RenderSettings settings() {
        RenderSettings settings;
        settings.crop = {0, 0, kSide, kSide};
        settings.samplesPerPixel = 600;
        settings.denoiser = DenoiserKind::Statistical; // the film keeps colours
        return settings;
    }

    /// The session until the curve is over.
    std::vector<CurvePoint> curveOf(double seconds) {
        UniformTracer truthTracer(1);
        RenderSession truthSession(truthTracer, settings(), 4.0);
        truthSession.run({});
        const GroundTruth truth(truthSession);
        PreparedTracer prepared;
        prepared.featureSeconds = kFeatureSeconds;
        prepared.denoise = [&](const FilmView& film, const std::function<void(double)>& onStep) {
            for (int run = 1; run <= 9; ++run) {
                std::this_thread::sleep_for(runTime_);
                onStep(run / 9.0);
            }
            return CleanPicture{film.picture(), "none", DenoisedError{0.5, 0.75, 1.0}, ""};
        };
        UniformTracer tracer(2);
        RenderSession session(tracer, settings(), 4.0);
        DenoisedCurve curve(prepared, session, truth, seconds, onProgress_);
        RenderObserver observer;
        observer.shouldStop = [&] { return curve.isOver(); };
        observer.onPass = [&](const RenderTotals&) { curve.onPass(); };
        session.run(observer);
        curve.finish();
        sampling_ = session.totals().seconds;
        picture_ = curve.picture();
        return curve.points();
    }

    std::chrono::milliseconds runTime_{2};
    std::function<void()> onProgress_ = [] {};
    double sampling_ = 0.0; ///< seconds
    std::optional<Image> picture_;
};

// The film holds whole blocks: 592 of 600 samples.
TEST_F(DenoisedCurveTest, HasAPointAtEachDoublingAndInTheEnd) {
    const std::vector<CurvePoint> points = curveOf(1e9);
    std::vector<double> samples;
    for (const CurvePoint& point : points)
        samples.push_back(point.samples);
    EXPECT_EQ(samples, (std::vector<double>{128.0, 256.0, 512.0, 592.0}));
    EXPECT_TRUE(picture_);
}

// Each of the features' pass, of sampling, and of denoising once, not of all denoising before.
TEST_F(DenoisedCurveTest, TimesIncludeDenoisingOnce) {
    const std::vector<CurvePoint> points = curveOf(1e9);
    ASSERT_EQ(points.size(), 4u);
    for (const CurvePoint& point : points) {
        EXPECT_GE(point.seconds, kFeatureSeconds + 9 * 0.002);
        EXPECT_EQ(point.stated, 0.5);
        EXPECT_EQ(point.bound, 0.75);
    }
    runTime_ = std::chrono::milliseconds(40);
    const double last = curveOf(1e9).back().seconds;
    EXPECT_GE(last, kFeatureSeconds + sampling_ + 9 * 0.04);
    EXPECT_LT(last, kFeatureSeconds + sampling_ + 3.5 * 9 * 0.04) << "four times it was denoised";
}

// What is known after a third of the runs is enough to give up.
TEST_F(DenoisedCurveTest, GivesUpADenoiserThatTakesTooLong) {
    runTime_ = std::chrono::milliseconds(50);
    int runs = 0;
    onProgress_ = [&] { ++runs; };
    EXPECT_TRUE(curveOf(kFeatureSeconds + 0.1).empty());
    EXPECT_FALSE(picture_);
    EXPECT_LT(runs, 9);
}

// The features alone took all of the time.
TEST_F(DenoisedCurveTest, HasNoPointWithoutTime) {
    EXPECT_TRUE(curveOf(0.5 * kFeatureSeconds).empty());
}

} // namespace
} // namespace calotype::test
