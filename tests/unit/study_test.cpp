// What a study makes of its measurements: curves of made-up renders whose answers are known.
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
#include "study/markup.h"
#include "study/page.h"
#include "study/plot.h"
#include "study/study.h"

namespace calotype::test {
namespace {

/// Points of the error sqrt(floor^2 + factor^2 / samples), `rate` samples a second.
Measurement madeUp(const std::string& name, double factor, double rate, double floor = 0.0) {
    Measurement measurement;
    measurement.variant = {name, name == "usual" ? "" : "--" + name, floor > 0.0, {}};
    measurement.isTrusted = true;
    for (uint64_t samples = 1; samples <= 1024; samples *= 2) {
        const auto count = static_cast<double>(samples);
        const double noise = factor / std::sqrt(count);
        measurement.curve.push_back(
            {count, count / rate, std::hypot(floor, noise), noise, Image(2, 2)});
    }
    return measurement;
}

TEST(StudyMeasurement, ReadsTimesOffItsCurve) {
    const Measurement one = madeUp("usual", 1.0, 10.0); // error^2 * seconds = 0.1
    for (const double target : {0.9, 0.1, 0.05, 0.01})
        EXPECT_NEAR(one.secondsTo(target).value(), 0.1 / (target * target), 1e-9);
    EXPECT_EQ(one.floor().value(), 0.0);
    // Above a floor of 0.2, which takes its part of the error.
    const Measurement low = madeUp("dark", 1.0, 10.0, 0.2);
    EXPECT_NEAR(low.floor().value(), 0.2, 1e-12);
    EXPECT_NEAR(low.secondsTo(0.2008).value(), 0.1 / (0.2008 * 0.2008 - 0.04), 1e-6);
    EXPECT_FALSE(low.secondsTo(0.2));
    EXPECT_FALSE(low.secondsTo(0.1));
    // Too few samples to know the floor: nothing is promised beyond what was measured.
    Measurement unknown = madeUp("dark", 1.0, 10.0, 0.2);
    unknown.curve.back().stated.reset();
    EXPECT_FALSE(unknown.floor());
    EXPECT_FALSE(unknown.secondsTo(0.2008));
    // Rare bright samples make an error look like one that stays.
    Measurement rare = madeUp("dark", 1.0, 10.0, 0.2);
    rare.isTrusted = false;
    EXPECT_FALSE(rare.floor());
}

TEST(StudyMeasurement, NothingIsKnownWithoutErrors) {
    Measurement blind = madeUp("blind", 1.0, 10.0);
    for (CurvePoint& point : blind.curve)
        point.error.reset();
    EXPECT_FALSE(blind.secondsTo(0.5));
    EXPECT_TRUE(paretoFront({blind}).empty());
}

TEST(StudyMeasurement, NothingBeatsTheFront) {
    const std::vector<Measurement> all = {madeUp("usual", 1.0, 10.0),
                                          madeUp("dark", 0.3, 10.0, 0.2), madeUp("slow", 1.0, 3.0)};
    const std::vector<CurvePoint> front = paretoFront(all);
    ASSERT_GT(front.size(), 4u);
    for (const Measurement& measurement : all)
        for (const CurvePoint& point : measurement.curve)
            EXPECT_TRUE(std::ranges::any_of(front, [&](const CurvePoint& best) {
                return best.seconds <= point.seconds && *best.error <= *point.error;
            }));
    for (const CurvePoint& best : front)
        for (const CurvePoint& other : front)
            EXPECT_FALSE(other.seconds < best.seconds && *other.error < *best.error);
    EXPECT_EQ(front.front().error, all[1].curve.front().error) << "dark but soon";
}

TEST(StudyAdvice, ComparesWithTheUsual) {
    const Measurement usual = madeUp("usual", 1.0, 10.0);
    const Measurement better = madeUp("better", 0.5, 8.0);
    const Comparison comparison = compare(better, usual);
    EXPECT_NEAR(comparison.timePerSample.value(), 1.25, 1e-12);
    EXPECT_NEAR(comparison.error.value(), 0.5, 1e-12);
    EXPECT_NEAR(comparison.time.value(), 1.25 * 0.25, 1e-9);
    const std::string sentence = sentenceOf(better, usual, 0.1);
    for (const char* part : {"1.25 times as long", "0.50 of the default", "0.31 times as long."})
        EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
    EXPECT_NE(sentenceOf(madeUp("same", 1.0, 10.0), usual, 0.1).find("as far as can be told"),
              std::string::npos);
    Measurement dark = madeUp("dark", 1.0, 10.0, 0.2);
    dark.brighter = -0.07;
    dark.brighterError = 0.01;
    EXPECT_NE(
        sentenceOf(dark, usual, 0.1).find("7.00 % darker, and the error never falls below 20.0 %"),
        std::string::npos)
        << sentenceOf(dark, usual, 0.1);
    Measurement dim = madeUp("dim", 1.0, 10.0, 0.001);
    dim.brighter = -0.01;
    dim.brighterError = 0.001;
    EXPECT_NE(sentenceOf(dim, usual, 0.1).find("1.00 % darker, which the error does not show yet"),
              std::string::npos);
    dim.isTrusted = false;
    dim.brighter = 0.3;
    EXPECT_NE(sentenceOf(dim, usual, 0.1).find("do not tell"), std::string::npos);
    dark.brighterError = 0.05;
    EXPECT_NE(sentenceOf(dark, usual, 0.1).find("none was seen"), std::string::npos);
}

// Of errors that do not fall as the root of samples only those of as many can be compared.
TEST(StudyAdvice, ComparesErrorsOfAsManySamples) {
    Measurement steep = madeUp("usual", 1.0, 10.0);
    for (CurvePoint& point : steep.curve)
        point.error = std::pow(point.samples, -0.7);
    const Measurement flat = madeUp("flat", 1.0, 10.0);
    EXPECT_NEAR(compare(flat, steep).error.value(), std::pow(1024.0, 0.2), 1e-9);
    Measurement few = steep;
    few.curve.resize(4);
    EXPECT_NEAR(compare(flat, few).error.value(), std::pow(8.0, 0.2), 1e-9);
    for (CurvePoint& point : few.curve)
        point.samples *= 1.3;
    EXPECT_FALSE(compare(flat, few).error);
}

// What the machine's pace could have done by chance is no reason to choose.
TEST(StudyAdvice, DoubtsTimesOfAnUnevenMachine) {
    Study study;
    study.measurements = {madeUp("usual", 1.0, 10.0), madeUp("quicker", 1.0, 13.0)};
    EXPECT_EQ(choicesOf(study)[0].measurement->variant.name, "quicker");
    study.paceSpread = 0.15;
    EXPECT_NEAR(study.timingNoise(), 0.3, 1e-12);
    EXPECT_EQ(choicesOf(study)[0].measurement->variant.name, "usual");
    const std::string sentence =
        sentenceOf(study.measurements[1], study.measurements[0], study.timingNoise());
    EXPECT_NE(sentence.find("as far as can be told"), std::string::npos) << sentence;
}

TEST(StudyAdvice, ChoosesWhatIsSoonestThere) {
    Study study;
    study.measurements = {madeUp("usual", 1.0, 10.0), madeUp("noise", 0.98, 10.0),
                          madeUp("dark", 0.2, 10.0, 0.03), madeUp("slow", 2.0, 10.0)};
    std::vector<Choice> choices = choicesOf(study);
    ASSERT_EQ(choices.size(), 3u);
    for (const Choice& choice : choices) {
        EXPECT_EQ(choice.measurement->variant.name, "usual") << "4 % are noise, 3 % lost light too";
        EXPECT_NEAR(choice.seconds, 0.1 / (choice.target * choice.target), 1e-6);
        EXPECT_EQ(choice.usual, choice.seconds);
    }
    study.measurements.push_back(madeUp("better", 0.5, 10.0));
    study.measurements.push_back(madeUp("dim", 0.1, 10.0, 0.02)); // enough for 5 %
    choices = choicesOf(study);
    EXPECT_EQ(choices[0].measurement->variant.name, "dim");
    EXPECT_EQ(choices[1].measurement->variant.name, "better");
    EXPECT_EQ(choices[2].measurement->variant.name, "better");
    study.measurements.clear();
    EXPECT_EQ(choicesOf(study)[0].measurement, nullptr);
}

TEST(StudyVariants, ChangeOneThingEach) {
    StudySettings usual;
    usual.render.maxBounces = 12;
    const std::vector<Variant> variants = variantsOf(usual, 0.5);
    EXPECT_EQ(variants.front().options, "");
    std::vector<std::string> options;
    for (const Variant& variant : variants)
        options.push_back(variant.options);
    for (const char* option :
         {"--adaptive", "--sampler independent", "--roulette off", "--mis off", "--max-bounces 6",
          "--max-bounces 3", "--clamp-indirect 5", "--clamp-indirect 0.5", "--light-choice uniform",
          "--bvh median", "--sampler independent --roulette off --mis off --max-bounces 4"})
        EXPECT_EQ(std::ranges::count(options, option), 1) << option;
    const std::vector<Variant> ofReference = variantsOf(usual, 0.5, true);
    EXPECT_EQ(ofReference.size(), variants.size() - 2);
    for (const Variant& variant : ofReference)
        EXPECT_TRUE(variant.name == "the default" ||
                    (!variant.options.empty() && variant.options != "--bvh median"));
    const Variant both = together({variants[1], variants[2]});
    EXPECT_EQ(both.options, "--adaptive --sampler independent");
    EXPECT_TRUE(both.settings(usual).adapts);
    EXPECT_EQ(both.settings(usual).render.sampler, Sampler::Independent);
}

TEST(StudyMarkup, IsWhatTheStandardsSay) {
    EXPECT_EQ(escaped("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
    // The start of every PNG, in base 64; and whole groups of four digits.
    for (const uint32_t width : {1u, 2u, 3u, 7u}) {
        const std::string uri = dataUri(Rgb8Image(width, 1));
        EXPECT_EQ(uri.rfind("data:image/png;base64,iVBORw0KGgo", 0), 0u) << uri;
        EXPECT_EQ((uri.size() - std::string("data:image/png;base64,").size()) % 4, 0u);
    }
}

/// Samples of known spread about 1, which take a made-up time.
class NoiseTracer : public BlockTracer {
public:
    explicit NoiseTracer(const StudySettings& settings)
        : settings_(settings),
          sums_(size_t{settings.render.crop.width} * settings.render.crop.height) {}

    uint32_t tileCount() const override { return 1; }

    void beginBlock(uint32_t firstSample, std::span<const uint8_t> isLeftOut) override {
        random_.seed(settings_.render.seed * 7919 + firstSample +
                     (settings_.render.sampler == Sampler::Sobol ? 0 : 1u << 30));
        for (size_t i = 0; i < sums_.size(); ++i)
            sums_[i] = {0, 0, 0, !isLeftOut.empty() && isLeftOut[i] ? 16.0f : 0.0f};
    }

    gpu::RenderCounters renderTiles(TileRange, uint32_t sampleEnd) override {
        gpu::RenderCounters counters{};
        const bool isNoisy = settings_.render.sampler == Sampler::Independent;
        const float mean = settings_.render.maxBounces < 8 ? 0.8f : 1.0f;
        std::normal_distribution<float> noise(mean, isNoisy ? 0.4f : 0.2f);
        for (glm::vec4& sum : sums_)
            for (; sum.w < static_cast<float>(sampleEnd); ++counters.paths)
                sum += glm::vec4(glm::vec3(noise(random_)), 1.0f);
        return counters;
    }

    std::span<const glm::vec4> readBlock() override { return sums_; }

private:
    StudySettings settings_;
    std::vector<glm::vec4> sums_;
    std::mt19937 random_;
};

StudyPlan planOf(double seconds) {
    StudyPlan plan;
    plan.usual.render.width = plan.usual.render.height = 64;
    plan.usual.render.crop = {0, 0, 64, 64};
    plan.usual.render.maxBounces = 8;
    plan.usual.render.sampler = Sampler::Sobol;
    plan.seconds = seconds;
    plan.keepsSize = true;
    return plan;
}

const PrepareTracer kPrepare = [](const StudySettings& settings) {
    const auto tracer = std::make_shared<NoiseTracer>(settings);
    return PreparedTracer{tracer, tracer.get(), 4.0, 0.01, 0.02};
};

/// After so many samples, of independent noise.
std::unique_ptr<RenderSession> noiseSession(NoiseTracer& tracer, const RenderSettings& settings) {
    auto session = std::make_unique<RenderSession>(tracer, settings, 4.0);
    session->run({});
    return session;
}

// From a reference of twice its samples a picture is a fifth further away than its error.
TEST(StudyReference, TakesOffItsOwnError) {
    StudySettings settings;
    settings.render.width = settings.render.height = 64;
    settings.render.crop = {0, 0, 64, 64};
    settings.render.maxBounces = 8;
    settings.render.samplesPerPixel = 256;
    NoiseTracer referenceTracer(settings);
    const auto referenceSession = noiseSession(referenceTracer, settings.render);
    const Reference reference(*referenceSession);
    EXPECT_NEAR(reference.error, 1.96 * 0.4 / 16.0, 0.003);
    settings.render.seed = 1;
    settings.render.samplesPerPixel = 128;
    NoiseTracer tracer(settings);
    const auto session = noiseSession(tracer, settings.render);
    EXPECT_NEAR(reference.errorOf(session->picture()).value(), 1.96 * 0.4 / std::sqrt(128.0),
                0.003);
    EXPECT_FALSE(reference.errorOf(reference.picture)) << "nearer than its own error";
}

const StudyObserver kPatient{[] { return false; }, [](const std::string&) {}};

// Through all of it: the errors are those of the noise that went in, and so is the advice.
TEST(TimedStudy, MeasuresWhatIsThere) {
    const Study study = runStudy(planOf(4.0), kPrepare, kPatient);
    ASSERT_EQ(study.ending, StudyEnding::Whole);
    ASSERT_TRUE(study.reference);
    EXPECT_TRUE(study.reference->isTrusted);
    size_t compared = 0;
    for (const Measurement& measurement : study.measurements) {
        SCOPED_TRACE(measurement.variant.name);
        EXPECT_EQ(measurement.buildSeconds, 0.01);
        EXPECT_EQ(measurement.compileSeconds, 0.02);
        const StudySettings settings = measurement.variant.settings(study.usual);
        if (measurement.variant.losesLight && settings.render.maxBounces < 8) {
            EXPECT_NEAR(measurement.brighter, -0.2, 0.01);
            EXPECT_NEAR(measurement.floor().value(), 1.96 * 0.2, 0.02);
            continue;
        }
        EXPECT_LT(std::abs(measurement.brighter), 4.0 * measurement.brighterError);
        if (settings.adapts)
            continue;
        const double sigma = settings.render.sampler == Sampler::Independent ? 0.4 : 0.2;
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
    SleepyTracer(const StudySettings& settings, const std::function<bool()>& isSlow)
        : NoiseTracer(settings), isSlow_(isSlow) {}

    gpu::RenderCounters renderTiles(TileRange tiles, uint32_t sampleEnd) override {
        std::this_thread::sleep_for(std::chrono::milliseconds(isSlow_() ? 6 : 2));
        return NoiseTracer::renderTiles(tiles, sampleEnd);
    }

private:
    const std::function<bool()>& isSlow_;
};

// A machine that gets slow half way through the variants does not make the later ones slow.
TEST(TimedStudy, CorrectsForTheMachinesPace) {
    StudyPlan plan = planOf(8.0);
    plan.usual.render.width = plan.usual.render.height = 16;
    plan.usual.render.crop = {0, 0, 16, 16};
    const auto start = std::chrono::steady_clock::now();
    const std::function<bool()> isSlow = [&] {
        return std::chrono::steady_clock::now() - start > std::chrono::milliseconds(5600);
    };
    const PrepareTracer prepare = [&](const StudySettings& settings) {
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

/// Throws from the moment that `fails` says so.
class FailingTracer : public NoiseTracer {
public:
    FailingTracer(const StudySettings& settings, const std::function<bool()>& fails)
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
TEST(TimedStudy, GoesOnWhereAVariantFails) {
    const PrepareTracer prepare = [](const StudySettings& settings) {
        if (settings.bvh == BvhBuilder::Median)
            throw GpuError("the device was lost.");
        return kPrepare(settings);
    };
    const Study study = runStudy(planOf(3.0), prepare, kPatient);
    EXPECT_EQ(study.ending, StudyEnding::Whole);
    ASSERT_EQ(study.failures.size(), 1u);
    EXPECT_EQ(study.failures[0].name, "median splits");
    EXPECT_EQ(study.measurements.back().variant.name, "the report's settings");
    const std::string page = toHtml(study, {"a.json", "none", "calotype render a.json"});
    EXPECT_NE(page.find("Not measured: median splits: the device was lost."), std::string::npos);
    // Where the pace cannot be measured any more, from the third variant on.
    int prepared = 0;
    const PrepareTracer failing = [&](const StudySettings& settings) {
        const bool isYardstick = ++prepared == 2;
        const auto tracer = std::make_shared<FailingTracer>(
            settings, [&prepared, isYardstick] { return isYardstick && prepared >= 5; });
        return PreparedTracer{tracer, tracer.get(), 4.0};
    };
    const Study lost = runStudy(planOf(3.0), failing, kPatient);
    EXPECT_GE(lost.failures.size(), 8u);
    ASSERT_EQ(lost.measurements.size(), 2u);
    for (const Measurement& measurement : lost.measurements)
        EXPECT_NEAR(measurement.pace, 1.0, 0.5);
    const PrepareTracer never = [](const StudySettings&) -> PreparedTracer {
        throw GpuError("the device was lost.");
    };
    EXPECT_THROW(runStudy(planOf(3.0), never, kPatient), GpuError);
}

// Preparations that take far longer than the budget has for them.
TEST(TimedStudy, EndsWithItsBudget) {
    const PrepareTracer slow = [](const StudySettings& settings) {
        std::this_thread::sleep_for(std::chrono::milliseconds(400));
        return kPrepare(settings);
    };
    const auto start = std::chrono::steady_clock::now();
    const Study study = runStudy(planOf(3.0), slow, kPatient);
    const std::chrono::duration<double> age = std::chrono::steady_clock::now() - start;
    EXPECT_LT(age.count(), 4.5);
    EXPECT_EQ(study.ending, StudyEnding::OutOfTime);
    EXPECT_GE(study.measurements.size(), 1u);
    EXPECT_THROW(runStudy(planOf(0.3), slow, kPatient), Error);
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

TEST(TimedStudy, SaysWhyThereIsNothingToStudy) {
    const auto messageOf = [](double seconds, const PrepareTracer& prepare) -> std::string {
        try {
            runStudy(planOf(seconds), prepare, kPatient);
        } catch (const Error& error) {
            return error.what();
        }
        return "";
    };
    const PrepareTracer black = [](const StudySettings& settings) {
        const auto tracer = std::make_shared<BlackTracer>(settings);
        return PreparedTracer{tracer, tracer.get(), 4.0};
    };
    EXPECT_NE(messageOf(2.0, black).find("black"), std::string::npos);
    EXPECT_NE(messageOf(0.001, kPrepare).find("too short"), std::string::npos);
}

// The user stops it while a variant is being prepared.
TEST(TimedStudy, StopsInAPreparation) {
    const PrepareTracer prepare = [](const StudySettings& settings) {
        if (!settings.render.transport.usesRoulette)
            throw StudyStopped();
        return kPrepare(settings);
    };
    const Study study = runStudy(planOf(3.0), prepare, kPatient);
    EXPECT_EQ(study.ending, StudyEnding::Stopped);
    EXPECT_EQ(study.measurements.back().variant.name, "independent samples");
}

TEST(TimedStudy, StoppedKeepsWhatIsWhole) {
    const auto start = std::chrono::steady_clock::now();
    const auto age = [&] {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    };
    const StudyObserver observer{[&] { return age() > 2.0; }, [](const std::string&) {}};
    const Study study = runStudy(planOf(4.0), kPrepare, observer);
    EXPECT_LT(age(), 3.0);
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
