#include "cli/render_report.h"

#include <cstdio>

#include "cli/progress.h"

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

/// ", error 1.93 %", or nothing where it is not known.
std::string errorText(const std::optional<ErrorEstimate>& error) {
    if (!error)
        return "";
    const bool isDoubtful = error->doubt && !error->isTrusted();
    return ", error " + percentText(error->relative) +
           (isDoubtful ? " (not to be trusted: it rests on rare bright samples)" : "");
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

/// A goal that was missed, or met by an estimate that says of itself that it may be wrong.
void warnOfGoal(const RenderReport& report) {
    const auto& [options, totals, ending, samplesWanted, film, cutPixels] = report;
    if (!options.targetError)
        return;
    const std::string target = percentText(*options.targetError);
    if (ending != RenderEnding::TargetError)
        std::fprintf(stderr,
                     "calotype: warning: the error of %s that --target-error asks for was not "
                     "reached%s\n",
                     target.c_str(),
                     totals.error ? (": it is " + percentText(totals.error->relative)).c_str()
                                  : "");
    else if (!totals.error->isTrusted())
        std::fprintf(stderr,
                     "calotype: warning: the error of %s is not to be trusted: it rests on pixels "
                     "where rare samples bring most of the light, and more of those may be missing "
                     "altogether\n",
                     percentText(totals.error->relative).c_str());
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
                 errorText(totals.error).c_str(), rate(totals.paths).c_str(),
                 rate(totals.rays).c_str());
}

} // namespace calotype
