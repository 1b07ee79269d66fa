#include <cinttypes>
#include <cstdio>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/output_failures.h"
#include "cli/check_outputs.h"
#include "cli/commands.h"
#include "cli/denoiser_library.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/interrupt_deadline.h"
#include "cli/picture_text.h"
#include "cli/progress.h"
#include "cli/read_scene.h"
#include "engine/film_json.h"
#include "engine/film_picture.h"
#include "engine/json_document.h"
#include "engine/merge_films.h"
#include "film/film_file.h"
#include "film/write_picture.h"
#include "image/image_format.h"

namespace calotype {
namespace {

constexpr const char* kInterrupted = "interrupted; nothing was written";

/// Which samples the films hold, and which are missing in between.
void printSamples(const Film& film) {
    std::printf("samples   %" PRIu64 " per pixel%s%s\n", film.samplesPerPixel(),
                film.blocks().empty() ? "" : ": ", sampleText(film.blocks()).c_str());
    if (const BlockRanges gaps = film.blocks().gaps(); !gaps.empty())
        std::printf("missing   %s\n", sampleText(gaps).c_str());
}

/// Whether the film holds all required samples; if not, prints which it lacks.
bool holdsRequired(const Film& film, const BlockRange& required) {
    const BlockRanges missing = film.blocks().missingFrom(required);
    if (!missing.empty())
        std::fprintf(stderr,
                     "calotype: the films lack samples of --require %s: %s; nothing was written\n",
                     sampleText(required).c_str(), sampleText(missing).c_str());
    return missing.empty();
}

/// The denoiser that the options name; null: off.
std::unique_ptr<const PictureDenoiser> denoiserOf(const MergeOptions& options) {
    RenderSettings settings;
    options.settings.applyTo(settings);
    if (settings.denoiser == DenoiserKind::Off)
        return nullptr;
    return std::make_unique<const PictureDenoiser>(settings.denoiser, denoiserLibrary());
}

/// Denoises what was joined, and prints the error; on standard error beside JSON.
CleanPicture denoised(const PictureDenoiser& denoiser, const MergeOptions& options,
                      const KeptFilm& joined) {
    if (const auto warning = featureWarning(options.films.front(), joined); !warning.empty())
        printWarning(warning);
    const InterruptDeadline deadline(kInterrupted);
    Progress progress(ProgressStyle::Text);
    CleanPicture clean =
        denoiseFilm(denoiser, options.films.front(), joined, options.threads, [&](double done) {
            throwIfInterrupted(kInterrupted);
            progress.step("denoising", done);
        });
    progress.clear();
    std::fprintf(options.asJson ? stderr : stdout, "denoised  by %s, %s\n", clean.denoiser.c_str(),
                 errorText(clean).c_str());
    return clean;
}

} // namespace

int mergeCommand(const MergeOptions& options) {
    catchInterrupts();
    const OutputClaims claims = checkOutputs(options);
    const auto denoiser = denoiserOf(options);
    const KeptFilm joined = mergeFilms(options.films, [] { throwIfInterrupted(kInterrupted); });
    throwIfInterrupted(kInterrupted);
    if (options.asJson)
        std::fputs(jsonText(filmJson(joined)).c_str(), stdout);
    else
        printSamples(joined.film);
    if (options.required && !holdsRequired(joined.film, *options.required))
        return kExitDiffers;
    for (const std::string& path : options.outputs)
        if (!imageFormatOf(path) && !options.overwrites)
            requireNoLess(path, joined);
    std::optional<CleanPicture> clean;
    if (denoiser)
        clean = denoised(*denoiser, options, joined);
    const DisplayTransform display =
        withExposureOf(clean ? clean->color : joined.film.picture(), options.display);
    OutputFailures failures;
    for (const std::string& path : options.outputs)
        failures.attempt([&] {
            if (imageFormatOf(path))
                writePicture(path, pictureOf(joined, options.layers, clean), display);
            else
                writeFilm(path, joined.label, joined.film, joined.features);
        });
    failures.throwIfAny();
    printExposure(options.outputs, chosenExposure(options.display, display));
    return kExitDone;
}

} // namespace calotype
