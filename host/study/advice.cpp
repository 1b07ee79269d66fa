#include "study/advice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/number_text.h"

namespace calotype {
namespace {

/// Numbers of samples count as equal if their logarithms differ by less.
constexpr double kAsMany = 0.1;

/// A remaining error below this share of the whole error is hidden by its noise.
constexpr double kSeenShare = 0.3;

std::string times(double ratio) {
    char text[32];
    std::snprintf(text, sizeof text, ratio < 9.95 ? "%.2f" : "%.0f", ratio);
    return text;
}

bool isNear(double ratio, double share) { return std::abs(std::log(ratio)) < share; }

double secondsPerSample(const CurvePoint& point) { return point.seconds / point.samples; }

/// From the last points of both curves that have equal numbers of samples and known errors.
std::optional<double> errorRatio(const Measurement& variant, const Measurement& usual) {
    for (auto mine = variant.curve.rbegin(); mine != variant.curve.rend(); ++mine)
        for (const CurvePoint& other : usual.curve) {
            const double ratio = mine->samples / other.samples;
            if (mine->error && other.error && isNear(ratio, kAsMany))
                return *mine->error / *other.error * std::sqrt(ratio);
        }
    return std::nullopt;
}

/// How much light a variant loses that loses light by design.
std::string lossOf(const Measurement& variant) {
    if (!variant.isTrusted)
        return "It may lose light. How much is unknown: there are too few samples, or most of the "
               "light comes from a few bright ones.";
    if (std::abs(variant.brighter) <= 3.0 * variant.brighterError)
        return "It may lose light. In this picture no loss was measured.";
    const std::string seen = "It loses light: the picture is " +
                             percentText(std::abs(variant.brighter)) +
                             (variant.brighter < 0.0 ? " darker" : " brighter");
    const double floor = variant.floor().value_or(0.0);
    const bool isInTheError = floor > kSeenShare * variant.last().error.value_or(0.0);
    return seen + (isInTheError ? ", and the error never falls below " + percentText(floor) + "."
                                : ", but its error is still mostly noise.");
}

void choose(const Measurement& measurement, double seconds, const Study& study, Choice& choice) {
    choice.measurement = &measurement;
    choice.seconds = seconds;
    choice.isExtrapolated = !measurement.reaches(choice.target);
    choice.options = measurement.variant.options;
    if (study.needsDenoiseOff && !measurement.variant.isDenoised)
        choice.options += std::string(choice.options.empty() ? "" : " ") + "--denoise off";
}

/// Of a denoised picture, and of the time that the usual settings need for the same error.
std::string denoisedSentence(const Measurement& variant, const Measurement& usual) {
    const CurvePoint& last = variant.last();
    std::string text = "With " + std::to_string(std::lround(last.samples)) +
                       " samples per pixel and denoising, " + durationText(last.seconds) + ", ";
    if (!last.error)
        return text + "the error is too small to measure against the ground truth.";
    text += "the picture has an error of " + percentText(*last.error) + ".";
    if (const auto seconds = usual.secondsTo(*last.error))
        text += " The default settings need " + durationText(*seconds) + " for that" +
                (usual.reaches(*last.error) ? "." : " (extrapolated).");
    return text;
}

} // namespace

Comparison compare(const Measurement& variant, const Measurement& usual) {
    Comparison comparison;
    if (variant.last().samples > 0.0 && usual.last().samples > 0.0)
        comparison.timePerSample =
            secondsPerSample(variant.last()) / secondsPerSample(usual.last());
    comparison.error = errorRatio(variant, usual);
    // Valid where the error falls with the square root of the time, so not where light is lost.
    if (comparison.timePerSample && comparison.error && !variant.variant.losesLight)
        comparison.time = *comparison.timePerSample * *comparison.error * *comparison.error;
    return comparison;
}

std::string sentenceOf(const Measurement& variant, const Measurement& usual, double noise) {
    if (variant.variant.isDenoised)
        return denoisedSentence(variant, usual);
    const Comparison comparison = compare(variant, usual);
    std::string text;
    if (comparison.timePerSample)
        text += "A sample takes " + times(*comparison.timePerSample) +
                " times as long as with the default settings";
    if (comparison.error)
        text += std::string(text.empty() ? "With" : "; with") +
                " the same number of samples the error is " + times(*comparison.error) +
                " times as large";
    if (!text.empty())
        text += ". ";
    if (comparison.time)
        text += isNear(*comparison.time, noise)
                    ? "The same error takes as long, within the measurement noise. "
                    : "The same error takes " + times(*comparison.time) + " times as long. ";
    if (variant.variant.losesLight)
        text += lossOf(variant);
    // The time of compiling is left out: it is long only if the kernel is not in the cache.
    const double longer = variant.buildSeconds - usual.buildSeconds;
    if (std::abs(longer) > std::max(0.2, 0.05 * usual.last().seconds))
        text += (text.ends_with(' ') ? "" : " ") + std::string("Its BVH is ready ") +
                durationText(std::abs(longer)) + (longer < 0.0 ? " sooner." : " later.");
    while (text.ends_with(' '))
        text.pop_back();
    return text;
}

std::string commandOf(const Choice& choice, const std::string& command) {
    return command + (choice.options.empty() ? "" : " " + choice.options) + " --target-error " +
           shortNumber(choice.target);
}

std::string whyNone(const Choice& choice) {
    // A denoiser may never reach it: its pictures are not extrapolated.
    return choice.isDenoised ? "not reached in this time"
                             : "unknown: the time budget was too short";
}

std::vector<Choice> choicesOf(const Study& study) {
    std::vector<Choice> choices;
    for (const double target : kTargets) {
        Choice choice;
        choice.target = target;
        for (const Measurement& measurement : study.measurements) {
            const auto floor = measurement.floor();
            if (measurement.variant.isDenoised || !floor || *floor > 0.5 * target)
                continue;
            const auto seconds = measurement.secondsTo(target);
            const bool isUsual = &measurement == &study.measurements.front();
            if (isUsual)
                choice.usual = seconds;
            // The kernel with all features has no option: it is measured for comparison only.
            if (!seconds || (!isUsual && measurement.variant.options.empty()))
                continue;
            const double most =
                choice.usual ? (1.0 - study.timingNoise()) * *choice.usual : *seconds;
            const bool isBetter = !choice.measurement || *seconds < choice.seconds;
            if (isUsual || (isBetter && *seconds <= most))
                choose(measurement, *seconds, study, choice);
        }
        choices.push_back(choice);
    }
    return choices;
}

std::vector<Choice> denoisedChoicesOf(const Study& study) {
    if (std::ranges::none_of(study.measurements,
                             [](const Measurement& one) { return one.variant.isDenoised; }))
        return {};
    std::vector<Choice> choices;
    for (const double target : kTargets) {
        Choice choice;
        choice.target = target;
        choice.isDenoised = true;
        choice.usual = study.measurements.front().secondsTo(target);
        for (const Measurement& measurement : study.measurements) {
            if (!measurement.variant.isDenoised)
                continue;
            const auto seconds = measurement.secondsTo(target);
            if (seconds && (!choice.measurement || *seconds < choice.seconds))
                choose(measurement, *seconds, study, choice);
        }
        choices.push_back(choice);
    }
    return choices;
}

} // namespace calotype
