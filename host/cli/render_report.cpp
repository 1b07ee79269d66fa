#include "cli/render_report.h"

#include <cmath>
#include <cstdio>

#include "base/names.h"
#include "base/number_text.h"
#include "cli/picture_text.h"
#include "cli/read_scene.h"
#include "cli/trust_text.h"

namespace calotype {
namespace {

/// " 1.93 %", with a remark if it cannot be relied on.
std::string estimateText(const ErrorEstimate& error) {
    return " " + percentText(error.relative) + trustText(error);
}

/// ", after denoising 1.3 % (at most 1.6 %)", or why nobody can say; empty if the picture was not
/// denoised.
std::string denoisedText(const RenderResult& result) {
    if (!result.isDenoised)
        return "";
    return result.denoised ? ", after denoising " + withBoundText(*result.denoised)
                           : ", denoised (" + unstatedText(result.whyUnstated) + ")";
}

/// All files that hold the picture: "a.exr, a.png, a.film".
std::string placesOf(const RenderOptions& options) {
    std::vector<std::string> paths = options.output.pictures;
    if (options.film.keepsFilm())
        paths.push_back(options.film.path());
    return listed(paths);
}

void reportInterrupt(const RenderOptions& options, const std::string& samples) {
    std::string text = "interrupted after " + samples;
    if (!options.output.pictures.empty())
        text += "; the picture so far is in " + listed(options.output.pictures);
    if (options.film.keepsFilm())
        text += "; its whole blocks of 16 samples are in the film " + options.film.path();
    if (options.film.keepsFilm() && !options.film.overwrites)
        text += "; the same command goes on with the film";
    std::fprintf(stderr, "calotype: %s\n", text.c_str());
}

/// The estimate, and how it compares with a target.
std::string judgedText(const ErrorEstimate& error, double target) {
    std::string text = ": it is" + estimateText(error);
    if (error.isTrusted() && std::isfinite(error.upperBound()))
        text += ", or up to " + percentText(error.upperBound()) +
                " within the uncertainty of the samples";
    if (error.relative <= target)
        text += "; it is judged at 128, 144, 160, ... samples per pixel alone, by what it may be "
                "at most";
    return text;
}

/// Warns if the target was not reached.
void warnOfGoal(const RenderResult& result) {
    const auto& target = result.plan.targetError;
    const auto& error = result.totals.error;
    if (!target || result.ending == RenderEnding::TargetError)
        return;
    if (result.denoised && result.denoised->upperBound <= *target)
        return;
    std::string found;
    if (result.denoised)
        found = ": after denoising it is " + percentText(result.denoised->relative) +
                ", or up to " + percentText(result.denoised->upperBound) +
                " within the uncertainty of the samples";
    else if (error)
        found = judgedText(*error, *target);
    printWarning("the error of " + targetText(*target) +
                 " that --target-error sets was not reached" + found);
}

/// What to do about an error that rests on rare light.
void warnOfRareLight(const RenderResult& result) {
    const auto& error = result.totals.error;
    if (error && error->trust() == Trust::RareLight)
        printWarning("the error is not to be trusted: most of the light comes from rare bright "
                     "samples, and more of it may be missing; render more samples, enlarge small "
                     "bright lamps, or use --clamp-indirect, which leaves such light out and so "
                     "darkens the picture");
}

} // namespace

void reportRender(const RenderOptions& options, const RenderResult& result) {
    const RenderTotals& totals = result.totals;
    const std::string samples =
        std::to_string(totals.samplesPerPixel) +
        (result.plan.samplesPerPixel ? " of " + std::to_string(*result.plan.samplesPerPixel)
                                     : std::string()) +
        " samples per pixel";
    if (result.ending == RenderEnding::Stopped)
        return reportInterrupt(options, samples);
    warnOfGoal(result);
    warnOfRareLight(result);
    if (options.quiet)
        return;
    if (totals.paths == 0) {
        std::fprintf(stderr, "%s: %s; the film holds all of them, and nothing was rendered%s\n",
                     placesOf(options).c_str(), samples.c_str(), denoisedText(result).c_str());
        return printExposure(options.output.pictures, result.exposureStops);
    }
    const auto rate = [&](uint64_t count) {
        return totals.seconds > 0.0 ? withPrefix(static_cast<double>(count) / totals.seconds)
                                    : std::string("0");
    };
    std::fprintf(stderr, "%s: %s in %s%s%s, %s samples/s, %s rays/s\n", placesOf(options).c_str(),
                 samples.c_str(), durationText(totals.seconds).c_str(),
                 totals.error ? (", error" + estimateText(*totals.error)).c_str() : "",
                 denoisedText(result).c_str(), rate(totals.paths).c_str(),
                 rate(totals.rays).c_str());
    printExposure(options.output.pictures, result.exposureStops);
}

} // namespace calotype
