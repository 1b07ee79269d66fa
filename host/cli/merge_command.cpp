#include <utility>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
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
        throw SceneError(path, "the film cannot be joined: the samples " +
                                   std::to_string(both.begin * gpu::kSamplesPerBlock) + ":" +
                                   std::to_string(both.end * gpu::kSamplesPerBlock) +
                                   " are in a film before it too");
    joined.film.add(next.film);
    joined.label.devices.insert(next.label.devices.begin(), next.label.devices.end());
}

/// With what EXR files say of how they came about.
void writePicture(const std::string& path, const KeptFilm& kept, const DisplayTransform& display) {
    const auto setting = [&](const char* name) {
        const auto found = kept.label.settings.find(name);
        return found == kept.label.settings.end() ? std::string() : found->second;
    };
    ExrMetadata metadata;
    metadata.version = setting("version");
    metadata.sceneHash = kept.label.sceneHash;
    metadata.sampler = setting("sampler");
    metadata.samplesPerPixel = static_cast<uint32_t>(kept.film.samplesPerPixel());
    writeImage(path, kept.film.picture(), display, metadata);
}

} // namespace

int mergeCommand(const MergeOptions& options) {
    KeptFilm joined = readFilm(options.films.front());
    for (size_t i = 1; i < options.films.size(); ++i)
        join(joined, options.films[i]);
    for (const std::string& path : options.outputs) {
        if (imageFormatOf(path))
            writePicture(path, joined, options.display);
        else
            writeFilm(path, joined.label, joined.film);
    }
    return kExitDone;
}

} // namespace calotype
