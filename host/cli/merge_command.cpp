#include "base/error.h"
#include "cli/check_outputs.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/exr_metadata.h"
#include "film/error_estimate.h"
#include "film/film_file.h"
#include "film/write_image.h"
#include "image/image_format.h"
#include "shared/limits.h"

namespace calotype {
namespace {

/// Adds a film to those joined so far. Throws SceneError where it does not go with them.
void join(KeptFilm& joined, const std::string& path) {
    const KeptFilm next = readFilm(path);
    requireSameOrigin(path, next, joined.label, joined.film.width(), joined.film.height(),
                      joined.film.unit());
    if (const BlockRange both = joined.film.blocks().firstOverlap(next.film.blocks()); both.end > 0)
        throw SceneError(path, "the film cannot be joined: the samples " + sampleText(both) +
                                   " are in a film before it too");
    joined.film.add(next.film);
    joined.label.devices.insert(next.label.devices.begin(), next.label.devices.end());
}

void writePicture(const std::string& path, const KeptFilm& kept, const MergeOptions& options) {
    std::vector<PixelError> errors;
    if (options.layers.errors)
        errors = pixelErrors(kept.film);
    ExrLayers layers;
    layers.errors = errors;
    writeImage(path, kept.film.picture(), options.display,
               exrMetadata(kept.label, kept.film.samplesPerPixel(), 0.0), layers);
}

} // namespace

int mergeCommand(const MergeOptions& options) {
    checkOutputs(options);
    KeptFilm joined = readFilm(options.films.front());
    for (size_t i = 1; i < options.films.size(); ++i)
        join(joined, options.films[i]);
    for (const std::string& path : options.outputs) {
        if (imageFormatOf(path))
            writePicture(path, joined, options);
        else
            writeFilm(path, joined.label, joined.film);
    }
    return kExitDone;
}

} // namespace calotype
