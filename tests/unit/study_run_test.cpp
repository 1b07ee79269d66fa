// Whole studies of made-up tracers: what they measure, and what becomes of them where time or
// tracers fail.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "render/render_session.h"
#include "study/advice.h"
#include "study/csv.h"
#include "study/page.h"
#include "study/plot.h"
#include "study/study.h"

namespace calotype::test {
namespace {

/// Samples of known spread about 1, which take a made-up time.
class NoiseTracer : public BlockTracer {
public:
    explicit NoiseTracer(const RenderSettings& settings)
        : settings_(settings), sums_(size_t{settings.crop.width} * settings.crop.height) {}

    uint32_t tileCount() const override { return 1; }

    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) override {
        random_.seed(settings_.seed * 7919 + firstSample +
                     (settings_.sampler == Sampler::Sobol ? 0 : 1u << 30));
        for (size_t i = 0; i < sums_.size(); ++i)
            sums_[i] = {0, 0, 0, !isLeftOut.empty() && isLeftOut[i] ? 16.0f : 0.0f};
    }

    shared::RenderCounters renderTiles(TileRange, uint32_t sampleEnd) override {
        shared::RenderCounters counters{};
        const bool isNoisy = settings_.sampler == Sampler::Independent;
        const float mean = settings_.maxBounces < 8 ? 0.8f : 1.0f;
        std::normal_distribution<float> noise(mean, isNoisy ? 0.4f : 0.2f);
        for (glm::vec4& sum : sums_)
            for (; sum.w < static_cast<float>(sampleEnd); ++counters.paths)
                sum += glm::vec4(glm::vec3(noise(random_)), 1.0f);
        return counters;
    }

    std::span<const glm::vec4> readBlock() override { return sums_; }

private:
    RenderSettings settings_;
    std::vector<glm::vec4> sums_;
    std::mt19937 random_;
};

StudyPlan planOf(double seconds) {
    StudyPlan plan;
    plan.usual.width = plan.usual.height = 64;
    plan.usual.crop = {0, 0, 64, 64};
    plan.usual.maxBounces = 8;
    plan.usual.sampler = Sampler::Sobol;
    plan.seconds = seconds;
    plan.keepsSize = true;
    return plan;
}

const PrepareTracer kPrepare = [](const RenderSettings& settings) {
    const auto tracer = std::make_shared<NoiseTracer>(settings);
    return PreparedTracer{tracer, tracer.get(), 4.0, 0.01, 0.02};
};

/// After so many samples, of independent noise.
std::unique_ptr<RenderSession> noiseSession(NoiseTracer& tracer, const RenderSettings& settings) {
    auto session = std::make_unique<RenderSession>(tracer, settings, 4.0);
    session->run({});
    return session;
}

// From a ground truth of twice its samples a picture is a fifth further away than its error.
TEST(StudyGroundTruthTest, TakesOffItsOwnError) {
    RenderSettings settings;
    settings.sampler = Sampler::Independent;
    settings.width = settings.height = 64;
    settings.crop = {0, 0, 64, 64};
    settings.maxBounces = 8;
    settings.samplesPerPixel = 256;
    NoiseTracer truthTracer(settings);
    const auto truthSession = noiseSession(truthTracer, settings);
    const GroundTruth truth(*truthSession);
    EXPECT_NEAR(truth.error, 1.96 * 0.4 / 16.0, 0.003);
    settings.seed = 1;
    settings.samplesPerPixel = 128;
    NoiseTracer tracer(settings);
    const auto session = noiseSession(tracer, settings);
    EXPECT_NEAR(truth.errorOf(session->picture()).value(), 1.96 * 0.4 / std::sqrt(128.0), 0.003);
    EXPECT_FALSE(truth.errorOf(truth.picture)) << "nearer than its own error";
}

const StudyObserver kPatient{[] { return false; }, [](const std::string&) {}};

// Through all of it: the errors are those of the noise that went in, and so is the advice.
TEST(TimedStudyTest, MeasuresWhatIsThere) {
    const Study study = runStudy(planOf(2.0), kPrepare, kPatient);
    ASSERT_EQ(study.ending, StudyEnding::Whole);
    ASSERT_TRUE(study.groundTruth);
    EXPECT_TRUE(study.groundTruth->isTrusted);
    size_t compared = 0;
    for (const Measurement& measurement : study.measurements) {
        SCOPED_TRACE(measurement.variant.name);
        EXPECT_EQ(measurement.buildSeconds, 0.01);
        EXPECT_EQ(measurement.compileSeconds, 0.02);
        const RenderSettings settings = measurement.variant.settings(study.usual);
        if (measurement.variant.losesLight && settings.maxBounces < 8) {
            EXPECT_NEAR(measurement.brighter, -0.2, 0.01);
            EXPECT_NEAR(measurement.floor().value(), 1.96 * 0.2, 0.02);
            continue;
        }
        EXPECT_LT(std::abs(measurement.brighter), 4.0 * measurement.brighterError);
        if (settings.isAdaptive)
            continue;
        const double sigma = settings.sampler == Sampler::Independent ? 0.4 : 0.2;
        for (const CurvePoint& point : measurement.curve)
            if (point.error && point.samples <= 64 && ++compared > 0) {
                const double truth = 1.96 * sigma / std::sqrt(point.samples);
                EXPECT_NEAR(*point.error / truth, 1.0, 0.1) << point.samples;
            }
    }
    EXPECT_GT(compared, 30u);
    const Comparison noisy = compare(study.measurements[2], study.measurements[0]);
    EXPECT_NEAR(noisy.error.value(), 2.0, 0.25);
}

/// Takes its time over every pass: three times as much once `isSlow`.
class SleepyTracer : public NoiseTracer {
public:
    SleepyTracer(const RenderSettings& settings, const std::function<bool()>& isSlow)
        : NoiseTracer(settings), isSlow_(isSlow) {}

    shared::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(isSlow_() ? 6 : 2));
        return NoiseTracer::renderTiles(tiles, sampleEnd);
    }

private:
    const std::function<bool()>& isSlow_;
};

// A machine that gets slow half way through the variants does not make the later ones slow.
TEST(TimedStudyTest, CorrectsForTheMachinesPace) {
    StudyPlan plan = planOf(8.0);
    plan.usual.width = plan.usual.height = 16;
    plan.usual.crop = {0, 0, 16, 16};
    const auto start = std::chrono::steady_clock::now();
    const std::function<bool()> isSlow = [&] {
        return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(5600);
    };
    const PrepareTracer prepare = [&](const RenderSettings& settings) {
        const auto tracer = std::make_shared<SleepyTracer>(settings, isSlow);
        return PreparedTracer{tracer, tracer.get(), 4.0};
    };
    const Study study = runStudy(plan, prepare, kPatient);
    const Measurement& late = study.measurements.back();
    EXPECT_GT(late.last().samples, 0.0);
    EXPECT_LT(late.last().samples, 0.6 * study.measurements.front().last().samples)
        << "it did get slow";
    EXPECT_NEAR(compare(late, study.measurements.front()).timePerSample.value(), 1.0, 0.25);
}

/// A study with a denoiser that halves the noise, and says that it leaves `stated`.
PrepareTracer halvingNoise(double stated) {
    return [=](const RenderSettings& settings) {
        PreparedTracer prepared = kPrepare(settings);
        prepared.featureSeconds = 0.01;
        prepared.denoise = [=](const FilmView& film, const std::function<void(double)>&) {
            CleanPicture clean{film.picture(), "made up", DenoisedError{stated, 1.1 * stated, 0.0},
                               ""};
            for (glm::vec3& pixel : clean.color.pixels)
                pixel = 0.5f * (pixel + 1.0f);
            return clean;
        };
        return prepared;
    };
}

/// The curve of the denoised variant; nothing if it was not measured.
const Measurement* denoisedIn(const Study& study) {
    for (const Measurement& measurement : study.measurements)
        if (measurement.variant.isDenoised)
            return &measurement;
    return nullptr;
}

TEST(TimedStudyTest, MeasuresDenoisedPictures) {
    StudyPlan plan = planOf(3.0);
    plan.usual.width = plan.usual.height = 16;
    plan.usual.crop = {0, 0, 16, 16};
    plan.denoisers = {DenoiserKind::Statistical};
    plan.omitted = {{"denoised by oidn", "cannot be used here"}};
    const Study study = runStudy(plan, halvingNoise(0.02), kPatient);
    ASSERT_EQ(study.ending, StudyEnding::Whole);
    const Measurement* denoised = denoisedIn(study);
    ASSERT_TRUE(denoised);
    ASSERT_GE(denoised->curve.size(), 2u);
    EXPECT_EQ(denoised->curve[0].samples, 128.0);
    EXPECT_EQ(denoised->curve[1].samples, 256.0);
    for (const CurvePoint& point : denoised->curve) {
        EXPECT_GE(point.seconds, denoised->pace * 0.01) << "the features";
        EXPECT_EQ(point.stated, 0.02);
        EXPECT_EQ(point.bound.value(), 1.1 * 0.02);
    }
    const double truth = 0.5 * 1.96 * 0.2 / std::sqrt(128.0);
    EXPECT_NEAR(denoised->curve[0].error.value() / truth, 1.0, 0.15);
    const std::string page = toHtml(study, {"a.json", "none", "calotype render a.json"});
    for (const char* part :
         {"Not measured: denoised by oidn: cannot be used here", "after denoising",
          "stated and true error", "stroke-dasharray=\"1 4\""})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

/// Throws from the moment that `fails` says so.
class FailingTracer : public NoiseTracer {
public:
    FailingTracer(const RenderSettings& settings, const std::function<bool()>& fails)
        : NoiseTracer(settings), fails_(fails) {}

    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) override {
        if (fails_())
            throw GpuError("the device was lost.");
        NoiseTracer::beginBlock(firstSample, isLeftOut);
    }

private:
    std::function<bool()> fails_;
};

// What one setting cannot do is no reason to lose the others.
TEST(TimedStudyTest, GoesOnWhereAVariantFails) {
    const PrepareTracer prepare = [](const RenderSettings& settings) {
        if (settings.bvh == BvhBuilder::Median)
            throw GpuError("the device was lost.");
        return kPrepare(settings);
    };
    const Study study = runStudy(planOf(1.5), prepare, kPatient);
    EXPECT_EQ(study.ending, StudyEnding::Whole);
    ASSERT_EQ(study.failures.size(), 1u);
    EXPECT_EQ(study.failures[0].name, "BVH by median splits");
    EXPECT_EQ(study.measurements.back().variant.name, "basic path tracing");
    const std::string page = toHtml(study, {"a.json", "none", "calotype render a.json"});
    EXPECT_NE(page.find("Not measured: BVH by median splits: the device was lost."),
              std::string::npos);
    // Where the pace cannot be measured any more, from the third variant on.
    int prepared = 0;
    const PrepareTracer failing = [&](const RenderSettings& settings) {
        const bool isYardstick = ++prepared == 2;
        const auto tracer = std::make_shared<FailingTracer>(
            settings, [&prepared, isYardstick] { return isYardstick && prepared >= 5; });
        return PreparedTracer{tracer, tracer.get(), 4.0};
    };
    const Study lost = runStudy(planOf(1.5), failing, kPatient);
    EXPECT_GE(lost.failures.size(), 8u);
    ASSERT_EQ(lost.measurements.size(), 2u);
    for (const Measurement& measurement : lost.measurements)
        EXPECT_NEAR(measurement.pace, 1.0, 0.5);
    const PrepareTracer never = [](const RenderSettings&) -> PreparedTracer {
        throw GpuError("the device was lost.");
    };
    EXPECT_THROW(runStudy(planOf(1.5), never, kPatient), GpuError);
}

// Preparations that take far longer than the budget has for them.
TEST(TimedStudyTest, EndsWithItsBudget) {
    const PrepareTracer slow = [](const RenderSettings& settings) {
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
        return kPrepare(settings);
    };
    const auto start = std::chrono::steady_clock::now();
    const Study study = runStudy(planOf(1.5), slow, kPatient);
    const std::chrono::duration<double> age = std::chrono::steady_clock::now() - start;
    EXPECT_LT(age.count(), 2.5);
    EXPECT_EQ(study.ending, StudyEnding::OutOfTime);
    EXPECT_GE(study.measurements.size(), 1u);
    EXPECT_THROW(runStudy(planOf(0.15), slow, kPatient), Error);
}

/// Its samples are all black.
class BlackTracer : public NoiseTracer {
public:
    using NoiseTracer::NoiseTracer;

    std::span<const glm::vec4> readBlock() override {
        for (const glm::vec4& sum : NoiseTracer::readBlock())
            black_.push_back({0.0f, 0.0f, 0.0f, sum.w});
        black_.erase(black_.begin(), black_.end() - 64 * 64);
        return black_;
    }

private:
    std::vector<glm::vec4> black_;
};

TEST(TimedStudyTest, SaysWhyThereIsNothingToStudy) {
    const auto messageOf = [](double seconds, const PrepareTracer& prepare) -> std::string {
        try {
            runStudy(planOf(seconds), prepare, kPatient);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    const PrepareTracer black = [](const RenderSettings& settings) {
        const auto tracer = std::make_shared<BlackTracer>(settings);
        return PreparedTracer{tracer, tracer.get(), 4.0};
    };
    EXPECT_NE(messageOf(2.0, black).find("black"), std::string::npos);
    EXPECT_NE(messageOf(0.001, kPrepare).find("too short"), std::string::npos);
}

// The user stops it while a variant is being prepared.
TEST(TimedStudyTest, StopsInAPreparation) {
    const PrepareTracer prepare = [](const RenderSettings& settings) {
        if (!settings.transport.usesRoulette)
            throw StudyStopped();
        return kPrepare(settings);
    };
    const Study study = runStudy(planOf(1.5), prepare, kPatient);
    EXPECT_EQ(study.ending, StudyEnding::Stopped);
    EXPECT_EQ(study.measurements.back().variant.name, "independent samples");
}

TEST(TimedStudyTest, StoppedKeepsWhatIsWhole) {
    const auto start = std::chrono::steady_clock::now();
    const auto age = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    // Of 2 s the ground truth takes about 0.9, and each variant 0.1.
    const StudyObserver observer{[&] { return age() > 1.3; }, [](const std::string&) {}};
    const Study study = runStudy(planOf(2.0), kPrepare, observer);
    EXPECT_LT(age(), 2.0);
    EXPECT_EQ(study.ending, StudyEnding::Stopped);
    ASSERT_GE(study.measurements.size(), 1u);
    EXPECT_LT(study.measurements.size(), 8u);
    const std::string page = toHtml(study, {"a<b.json", "none", "calotype render a<b.json"});
    EXPECT_NE(page.find("stopped before its end"), std::string::npos);
    EXPECT_EQ(page.find("a<b"), std::string::npos) << "escaped";
    // Nothing is loaded from anywhere.
    for (const char* reference : {"src=\"http", "href=", "@import", "url(", "<script"})
        EXPECT_EQ(page.find(reference), std::string::npos) << reference;
    const std::string csv = toCsv(study);
    size_t points = 0;
    for (const Measurement& measurement : study.measurements)
        points += measurement.curve.size();
    EXPECT_EQ(static_cast<size_t>(std::ranges::count(csv, '\n')), points + 1);
    const std::string svg = toSvg(study, "x & y");
    EXPECT_NE(svg.find("x &amp; y"), std::string::npos);
    for (const char* word : {"nan", "inf"}) {
        EXPECT_EQ(csv.find(word), std::string::npos) << word;
        EXPECT_EQ(svg.find(word), std::string::npos) << word;
    }
}

} // namespace
} // namespace calotype::test
