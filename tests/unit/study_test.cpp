// What a study makes of its measurements: curves of made-up renders whose answers are known.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/advice.h"
#include "study/markup.h"
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

TEST(StudyMeasurementTest, ReadsTimesOffItsCurve) {
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
    // Too few samples to find the floor: nothing is promised beyond what was measured.
    Measurement unknown = madeUp("dark", 1.0, 10.0, 0.2);
    unknown.curve.back().stated.reset();
    EXPECT_FALSE(unknown.floor());
    EXPECT_FALSE(unknown.secondsTo(0.2008));
    // Rare bright samples make an error look like one that stays.
    Measurement rare = madeUp("dark", 1.0, 10.0, 0.2);
    rare.isTrusted = false;
    EXPECT_FALSE(rare.floor());
}

TEST(StudyMeasurementTest, NothingIsKnownWithoutErrors) {
    Measurement blind = madeUp("blind", 1.0, 10.0);
    for (CurvePoint& point : blind.curve)
        point.error.reset();
    EXPECT_FALSE(blind.secondsTo(0.5));
    EXPECT_TRUE(paretoFront({blind}).empty());
}

TEST(StudyMeasurementTest, NothingBeatsTheFront) {
    const std::vector<Measurement> all = {madeUp("usual", 1.0, 10.0),
                                          madeUp("dark", 0.3, 10.0, 0.2), madeUp("slow", 1.0, 3.0)};
    const std::vector<FrontPoint> front = paretoFront(all);
    ASSERT_GT(front.size(), 4u);
    for (const Measurement& measurement : all)
        for (const CurvePoint& point : measurement.curve)
            EXPECT_TRUE(std::ranges::any_of(front, [&](const FrontPoint& best) {
                return best.seconds <= point.seconds && best.error <= *point.error;
            }));
    for (size_t i = 1; i < front.size(); ++i) {
        EXPECT_GE(front[i].seconds, front[i - 1].seconds);
        EXPECT_LE(front[i].error, front[i - 1].error);
    }
    EXPECT_EQ(front.front().error, *all[1].curve.front().error) << "dark but soon";
}

// Between its points the front of one curve is the curve: error = seconds^(-1/2) here.
TEST(StudyMeasurementTest, TheFrontRunsAlongTheCurves) {
    Measurement only = madeUp("usual", 1.0, 10.0);
    for (CurvePoint& point : only.curve)
        point.error = 1.0 / std::sqrt(point.seconds);
    const std::vector<FrontPoint> front = paretoFront({only});
    ASSERT_GT(front.size(), 3 * only.curve.size());
    for (const FrontPoint& point : front)
        EXPECT_NEAR(point.error * std::sqrt(point.seconds), 1.0, 1e-9);
}

TEST(StudyAdviceTest, GivesTheCommandOfTheChoice) {
    Study study;
    study.measurements = {madeUp("usual", 1.0, 10.0), madeUp("quick", 0.1, 10.0)};
    study.measurements[1].variant.options = "--adaptive";
    const Choice choice = choicesOf(study)[1];
    EXPECT_EQ(commandOf(choice, "calotype render a.json -o a.exr"),
              "calotype render a.json -o a.exr --adaptive --target-error 0.02");
    // The time of a smaller error than any that was measured is extrapolated.
    const double reached = *study.measurements[1].last().error;
    for (const Choice& one : choicesOf(study))
        EXPECT_EQ(one.isExtrapolated, one.target < reached) << one.target;
}

TEST(StudyAdviceTest, ComparesWithTheUsual) {
    const Measurement usual = madeUp("usual", 1.0, 10.0);
    const Measurement better = madeUp("better", 0.5, 8.0);
    const Comparison comparison = compare(better, usual);
    EXPECT_NEAR(comparison.timePerSample.value(), 1.25, 1e-12);
    EXPECT_NEAR(comparison.error.value(), 0.5, 1e-12);
    EXPECT_NEAR(comparison.time.value(), 1.25 * 0.25, 1e-9);
    const std::string sentence = sentenceOf(better, usual, 0.1);
    for (const char* part : {"1.25 times as long", "0.50 times as large", "0.31 times as long."})
        EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
    EXPECT_NE(
        sentenceOf(madeUp("same", 1.0, 10.0), usual, 0.1).find("within the measurement noise"),
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
    EXPECT_NE(
        sentenceOf(dim, usual, 0.1).find("1.00 % darker, but its error is still mostly noise"),
        std::string::npos);
    dim.isTrusted = false;
    dim.brighter = 0.3;
    EXPECT_NE(sentenceOf(dim, usual, 0.1).find("How much is unknown"), std::string::npos);
    dark.brighterError = 0.05;
    EXPECT_NE(sentenceOf(dark, usual, 0.1).find("no loss was measured"), std::string::npos);
}

// Of errors that do not fall as the root of samples only those of as many can be compared.
TEST(StudyAdviceTest, ComparesErrorsOfAsManySamples) {
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
TEST(StudyAdviceTest, DoubtsTimesOfAnUnevenMachine) {
    Study study;
    study.measurements = {madeUp("usual", 1.0, 10.0), madeUp("quicker", 1.0, 13.0)};
    EXPECT_EQ(choicesOf(study)[0].measurement->variant.name, "quicker");
    study.paceSpread = 0.15;
    EXPECT_NEAR(study.timingNoise(), 0.3, 1e-12);
    EXPECT_EQ(choicesOf(study)[0].measurement->variant.name, "usual");
    const std::string sentence =
        sentenceOf(study.measurements[1], study.measurements[0], study.timingNoise());
    EXPECT_NE(sentence.find("within the measurement noise"), std::string::npos) << sentence;
}

TEST(StudyAdviceTest, ChoosesWhatIsSoonestThere) {
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

/// A variant whose error falls as the fourth root of the time, from 128 samples on.
Measurement madeUpDenoised(const std::string& name, double factor) {
    Measurement measurement;
    measurement.variant = {name, "--denoise " + name, false, {}, false, true};
    measurement.isTrusted = true;
    for (double samples = 128.0; samples <= 1024.0; samples *= 2.0) {
        const double error = factor / std::sqrt(std::sqrt(samples / 10.0));
        measurement.curve.push_back({samples, samples / 10.0, error, 1.05 * error, Image(2, 2)});
    }
    return measurement;
}

TEST(StudyMeasurementTest, ExtrapolatesNoDenoiser) {
    const Measurement one = madeUpDenoised("oidn", 0.1); // 5.3 % after 12.8 s, 3.1 % after 102 s
    EXPECT_NEAR(one.secondsTo(0.04).value(), std::pow(0.1 / 0.04, 4.0), 1e-6);
    EXPECT_EQ(one.secondsTo(0.1), 12.8) << "its first picture";
    EXPECT_FALSE(one.secondsTo(0.03));
}

// Errors after denoising are another thing than those of samples: each has recommendations.
TEST(StudyAdviceTest, RecommendsDenoisersApart) {
    Study study;
    study.measurements = {madeUp("usual", 1.0, 10.0)};
    EXPECT_TRUE(denoisedChoicesOf(study).empty());
    study.measurements.push_back(madeUpDenoised("statistical", 0.1));
    study.measurements.push_back(madeUpDenoised("oidn", 0.08));
    for (const Choice& choice : choicesOf(study))
        EXPECT_EQ(choice.measurement->variant.name, "usual");
    const std::vector<Choice> choices = denoisedChoicesOf(study);
    ASSERT_EQ(choices.size(), kTargets.size());
    EXPECT_EQ(choices[0].measurement->variant.name, "oidn");
    EXPECT_EQ(choices[0].seconds, 12.8);
    EXPECT_NEAR(choices[0].usual.value(), 0.1 / (0.05 * 0.05), 1e-9);
    EXPECT_FALSE(choices[0].isExtrapolated);
    EXPECT_EQ(choices[2].measurement, nullptr) << "1 % is not reached";
    EXPECT_EQ(whyNone(choices[2]), "not reached in this time");
    EXPECT_EQ(whyNone(choicesOf(study)[2]), "unknown: the time budget was too short");
    EXPECT_EQ(commandOf(choices[0], "calotype render a.json"),
              "calotype render a.json --denoise oidn --target-error 0.05");
    study.needsDenoiseOff = true; // as the scene names a denoiser
    EXPECT_EQ(commandOf(choicesOf(study)[0], "calotype render a.json"),
              "calotype render a.json --denoise off --target-error 0.05");
    EXPECT_EQ(denoisedChoicesOf(study)[0].options, "--denoise oidn");
    const std::string sentence = sentenceOf(study.measurements[2], study.measurements[0], 0.1);
    EXPECT_NE(sentence.find("With 1024 samples per pixel and denoising, 1:42"), std::string::npos)
        << sentence;
    EXPECT_NE(sentence.find("The default settings need"), std::string::npos) << sentence;
}

TEST(StudyVariantsTest, ChangeOneThingEach) {
    RenderSettings usual;
    usual.maxBounces = 12;
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
    const Variant denoised = denoisedVariant(usual, DenoiserKind::Statistical);
    EXPECT_EQ(denoised.options, "--denoise statistical");
    EXPECT_EQ(denoised.settings(usual).denoiser, DenoiserKind::Statistical);
    EXPECT_FALSE(denoised.isOneChange);
    const Variant both = together(usual, {variants[1], variants[2]});
    EXPECT_EQ(both.options, "--adaptive --sampler independent");
    EXPECT_TRUE(both.settings(usual).isAdaptive);
    EXPECT_EQ(both.settings(usual).sampler, Sampler::Independent);
}

TEST(StudyMarkupTest, IsWhatTheStandardsSay) {
    EXPECT_EQ(escaped("a<b & \"c\">"), "a&lt;b &amp; &quot;c&quot;&gt;");
    // The start of every PNG, in base 64; and whole groups of four digits.
    for (const uint32_t width : {1u, 2u, 3u, 7u}) {
        const std::string uri = dataUri(Rgb8Image(width, 1));
        EXPECT_EQ(uri.rfind("data:image/png;base64,iVBORw0KGgo", 0), 0u) << uri;
        EXPECT_EQ((uri.size() - std::string("data:image/png;base64,").size()) % 4, 0u);
    }
}

} // namespace
} // namespace calotype::test
