#include <cinttypes>
#include <cstdio>

#include <nlohmann/json.hpp>

#include "base/output_failures.h"
#include "cli/check_outputs.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
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

} // namespace

int mergeCommand(const MergeOptions& options) {
    catchInterrupts();
    const OutputClaims claims = checkOutputs(options);
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
    OutputFailures failures;
    for (const std::string& path : options.outputs)
        failures.attempt([&] {
            if (imageFormatOf(path))
                writePicture(path, pictureOf(joined, options.layers, options.stages, {}),
                             options.display);
            else
                writeFilm(path, joined.label, joined.film, joined.features);
        });
    failures.throwIfAny();
    return kExitDone;
}

} // namespace calotype
