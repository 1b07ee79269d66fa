#include "study/advice.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/number_text.h"

namespace calotype {
namespace {

/// Numbers of samples that differ by no more are as many.
constexpr double kAsMany = 0.1;

/// A floor of less than this share of an error is lost in its noise.
constexpr double kSeenShare = 0.3;

std::string times(double ratio) {
    char text[32];
    std::snprintf(text, sizeof text, ratio < 9.95 ? "%.2f" : "%.0f", ratio);
    return text;
}

bool isNear(double ratio, double share) { return std::abs(std::log(ratio)) < share; }

double secondsPerSample(const CurvePoint& point) { return point.seconds / point.samples; }

/// The last point of both curves with as many samples, but for a tenth, and known errors.
std::optional<double> errorRatio(const Measurement& variant, const Measurement& usual) {
    for (auto mine = variant.curve.rbegin(); mine != variant.curve.rend(); ++mine)
        for (const CurvePoint& other : usual.curve) {
            const double ratio = mine->samples / other.samples;
            if (mine->error && other.error && isNear(ratio, kAsMany))
                return *mine->error / *other.error * std::sqrt(ratio);
        }
    return std::nullopt;
}

/// What of the light a variant loses that is made to.
std::string lossOf(const Measurement& variant) {
    if (!variant.isTrusted)
        return "It may lose light; how much, so few samples, or such rare bright ones, do not "
               "tell.";
    if (std::abs(variant.brighter) <= 3.0 * variant.brighterError)
        return "It may lose light; here none was seen to be missing.";
    const std::string seen = "It loses light: the picture is " +
                             percentText(std::abs(variant.brighter)) +
                             (variant.brighter < 0.0 ? " darker" : " brighter");
    const double floor = variant.floor().value_or(0.0);
    const bool isInTheError = floor > kSeenShare * variant.last().error.value_or(0.0);
    return seen + (isInTheError ? ", and the error never falls below " + percentText(floor) + "."
                                : ", which the error does not show yet.");
}

} // namespace

Comparison compare(const Measurement& variant, const Measurement& usual) {
    Comparison comparison;
    if (variant.last().samples > 0.0 && usual.last().samples > 0.0)
        comparison.timePerSample =
            secondsPerSample(variant.last()) / secondsPerSample(usual.last());
    comparison.error = errorRatio(variant, usual);
    // An error that falls as the root of time; near a floor there is no such thing.
    if (comparison.timePerSample && comparison.error && !variant.variant.losesLight)
        comparison.time = *comparison.timePerSample * *comparison.error * *comparison.error;
    return comparison;
}

std::string sentenceOf(const Measurement& variant, const Measurement& usual, double noise) {
    const Comparison comparison = compare(variant, usual);
    std::string text;
    if (comparison.timePerSample)
        text += "A sample takes " + times(*comparison.timePerSample) + " times as long";
    if (comparison.error)
        text += (text.empty() ? "The error is " : "; at as many samples the error is ") +
                times(*comparison.error) + " of the default's";
    if (!text.empty())
        text += ". ";
    if (comparison.time)
        text += isNear(*comparison.time, noise)
                    ? "To the same error it takes as long, as far as can be told. "
                    : "To the same error it takes " + times(*comparison.time) + " times as long. ";
    if (variant.variant.losesLight)
        text += lossOf(variant);
    // Not of compiling: that takes long only where the kernel is not yet in the cache.
    const double longer = variant.buildSeconds - usual.buildSeconds;
    if (std::abs(longer) > std::max(0.2, 0.05 * usual.last().seconds))
        text += (text.ends_with(' ') ? "" : " ") + std::string("Its tree is ready ") +
                durationText(std::abs(longer)) + (longer < 0.0 ? " sooner." : " later.");
    while (text.ends_with(' '))
        text.pop_back();
    return text;
}

std::vector<Choice> choicesOf(const Study& study) {
    std::vector<Choice> choices;
    for (const double target : kTargets) {
        Choice choice{target, nullptr, 0.0, std::nullopt};
        for (const Measurement& measurement : study.measurements) {
            const auto floor = measurement.floor();
            if (!floor || *floor > 0.5 * target)
                continue;
            const auto seconds = measurement.secondsTo(target);
            const bool isUsual = &measurement == &study.measurements.front();
            if (isUsual)
                choice.usual = seconds;
            // A kernel of everything is no choice: it is there to be compared.
            if (!seconds || (!isUsual && measurement.variant.options.empty()))
                continue;
            const double most =
                choice.usual ? (1.0 - study.timingNoise()) * *choice.usual : *seconds;
            const bool isBetter = !choice.measurement || *seconds < choice.seconds;
            if (isUsual || (isBetter && *seconds <= most)) {
                choice.measurement = &measurement;
                choice.seconds = *seconds;
            }
        }
        choices.push_back(choice);
    }
    return choices;
}

} // namespace calotype
