#include "cli/check_outputs.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "engine/exr_metadata.h"
#include "engine/merge_films.h"
#include "film/develop.h"
#include "film/film_file.h"
#include "film/write_picture.h"
#include "image/image_format.h"
#include "image/layers.h"

namespace calotype {
namespace {

Picture pictureOf(const KeptFilm& kept, const MergeOptions& options) {
    Picture picture = develop(kept.film.picture(), options.layers, options.stages,
                              [&](const Layer& layer) { return channelsOf(layer, kept.film); });
    describe(picture, kept.label, kept.film.samplesPerPixel(), 0.0);
    return picture;
}

} // namespace

int mergeCommand(const MergeOptions& options) {
    checkOutputs(options);
    const KeptFilm joined = mergeFilms(options.films);
    for (const std::string& path : options.outputs)
        if (imageFormatOf(path))
            writePicture(path, pictureOf(joined, options), options.display);
        else
            writeFilm(path, joined.label, joined.film);
    return kExitDone;
}

} // namespace calotype
