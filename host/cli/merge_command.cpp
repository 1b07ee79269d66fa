#include "base/error.h"
#include "cli/check_outputs.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/exr_metadata.h"
#include "film/develop.h"
#include "film/film_file.h"
#include "film/write_picture.h"
#include "image/image_format.h"
#include "image/layers.h"
#include "shared/limits.h"

namespace calotype {
namespace {

/// Adds a film to those joined so far. Throws SceneError where it does not go with them.
void join(KeptFilm& joined, const std::string& path) {
    const KeptFilm next = readFilm(path);
    requireSameOrigin(path, next, joined.label, joined.film.width(), joined.film.height(),
                      joined.film.unit(), joined.film.channels());
    if (const BlockRange both = joined.film.blocks().firstOverlap(next.film.blocks()); both.end > 0)
        throw SceneError(path, "the film cannot be joined: the samples " + sampleText(both) +
                                   " are in a film before it too");
    joined.film.add(next.film);
    joined.label.devices.insert(next.label.devices.begin(), next.label.devices.end());
}

Picture pictureOf(const KeptFilm& kept, const MergeOptions& options) {
    Picture picture = develop(kept.film.picture(), options.layers, options.stages,
                              [&](const Layer& layer) { return channelsOf(layer, kept.film); });
    describe(picture, kept.label, kept.film.samplesPerPixel(), 0.0);
    return picture;
}

} // namespace

int mergeCommand(const MergeOptions& options) {
    checkOutputs(options);
    KeptFilm joined = readFilm(options.films.front());
    for (size_t i = 1; i < options.films.size(); ++i)
        join(joined, options.films[i]);
    for (const std::string& path : options.outputs) {
        if (imageFormatOf(path))
            writePicture(path, pictureOf(joined, options), options.display);
        else
            writeFilm(path, joined.label, joined.film);
    }
    return kExitDone;
}

} // namespace calotype
