#include "cli/render_report.h"

#include <cmath>
#include <cstdio>

#include "base/number_text.h"

namespace calotype {
namespace {

void warn(uint64_t count, const char* text) {
    if (count > 0)
        std::fprintf(stderr, "calotype: warning: %llu %s\n", static_cast<unsigned long long>(count),
                     text);
}

void warnOfLosses(const FilmLosses& losses, uint64_t cutPixels) {
    warn(losses.nonFiniteSamples, "samples were not finite and count as black");
    warn(losses.cutPaths, "paths were cut short by the device's loop limit, so the picture is "
                          "too dark; lower --max-bounces, use fewer transparent layers, or take a "
                          "GPU");
    warn(cutPixels, "pixels lie behind more transparent surfaces than the layers of --aov see "
                    "through, and show one of those as if it were opaque");
    warn(losses.lostPixels(), "blocks of samples were too bright for the film and count as black");
}

/// " 1.93 %", with a word where more light may be missing altogether.
std::string estimateText(const ErrorEstimate& error) {
    const bool isDoubtful = error.doubt && !error.isTrusted();
    return std::string(" ")
        .append(percentText(error.relative))
        .append(isDoubtful ? " (not to be trusted: it rests on rare bright samples)" : "");
}

/// Where the picture or the film is.
std::string placeOf(const RenderReport& report) {
    return report.options.outputs.empty() ? report.film : report.options.outputs.front();
}

void reportInterrupt(const RenderReport& report, const std::string& samples) {
    const char* what = report.options.outputs.empty() ? "film" : "picture";
    std::fprintf(stderr, "calotype: interrupted after %s; the %s so far is in %s\n",
                 samples.c_str(), what, placeOf(report).c_str());
}

/// The estimate, and how a goal is judged by it.
std::string judgedText(const ErrorEstimate& error, double target) {
    std::string text = ": it is" + estimateText(error);
    if (error.isTrusted() && std::isfinite(error.upperBound()))
        text += ", or up to " + percentText(error.upperBound()) + " for all that the samples tell";
    if (error.relative <= target)
        text +=
            "; it is judged after 128, 256, 512, ... samples per pixel alone, by what it may be "
            "at most";
    return text;
}

/// A goal that was missed.
void warnOfGoal(const RenderReport& report) {
    const auto& [options, totals, ending, samplesWanted, film, cutPixels] = report;
    if (options.targetError && ending != RenderEnding::TargetError)
        std::fprintf(stderr,
                     "calotype: warning: the error of %s that --target-error asks for was not "
                     "reached%s\n",
                     percentText(*options.targetError).c_str(),
                     totals.error ? judgedText(*totals.error, *options.targetError).c_str() : "");
}

} // namespace

void reportRender(const RenderReport& report) {
    const auto& [options, totals, ending, samplesWanted, film, cutPixels] = report;
    warnOfLosses(totals.losses, cutPixels);
    const std::string samples =
        std::to_string(totals.samplesPerPixel) +
        (samplesWanted ? " of " + std::to_string(*samplesWanted) : std::string()) +
        " samples per pixel";
    if (ending == RenderEnding::Stopped)
        return reportInterrupt(report, samples);
    warnOfGoal(report);
    if (options.quiet)
        return;
    const auto rate = [&](uint64_t count) {
        return totals.seconds > 0.0 ? withPrefix(static_cast<double>(count) / totals.seconds)
                                    : std::string("0");
    };
    std::fprintf(stderr, "%s: %s in %s%s, %s samples/s, %s rays/s\n", placeOf(report).c_str(),
                 samples.c_str(), durationText(totals.seconds).c_str(),
                 totals.error ? (", error" + estimateText(*totals.error)).c_str() : "",
                 rate(totals.paths).c_str(), rate(totals.rays).c_str());
}

} // namespace calotype
