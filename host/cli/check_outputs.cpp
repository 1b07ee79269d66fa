#include "cli/check_outputs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/atomic_file.h"
#include "base/error.h"
#include "image/image_format.h"

namespace calotype {
namespace {

bool isExr(const std::string& path) { return imageFormatOf(path) == ImageFormat::Exr; }

} // namespace

void checkOutputs(const RenderOptions& options) {
    std::set<std::filesystem::path> taken = {std::filesystem::weakly_canonical(options.scene.path)};
    std::error_code ignored; // a path that cannot be resolved cannot be written either
    const FilmOptions& film = options.film;
    if (!film.film.empty() && film.resume != film.film) // else it is claimed below, to be written
        taken.insert(std::filesystem::weakly_canonical(film.resume, ignored));
    const auto claim = [&](const std::string& path) {
        if (!taken.insert(std::filesystem::weakly_canonical(path, ignored)).second)
            throw UsageError("'" + path + "' is the scene, or is given twice");
        checkWritable(path);
    };
    const auto claimPicture = [&](const std::string& path) {
        if (!imageFormatOf(path))
            throw UsageError("the picture '" + path + "' has no known extension; use " +
                             std::string(kImageExtensions));
        claim(path);
    };
    const bool keepsFilm = !film.film.empty() || !film.resume.empty();
    if (options.outputs.empty() && !keepsFilm)
        throw UsageError(
            "there is nothing to write; name a picture with -o, or a film with --film");
    for (const std::string& path : options.outputs)
        claimPicture(path);
    const bool wantsLayers = options.layers.errors || !options.layers.firstHits.empty();
    if (wantsLayers && std::ranges::none_of(options.outputs, isExr))
        throw UsageError("--aov writes layers of EXR files, and no output is one; add -o FILE.exr");
    if (film.checkpointSeconds && !keepsFilm)
        throw UsageError("--checkpoint is how often a film is kept, and none is; add --film FILE");
    const auto claimFilm = [&](const std::string& path) {
        if (imageFormatOf(path))
            throw UsageError("the film '" + path +
                             "' has the extension of a picture; name it otherwise, such as x.film");
        if (std::filesystem::exists(path, ignored) &&
            !std::filesystem::is_regular_file(path, ignored))
            throw UsageError("the film '" + path + "' is no file that can be read again");
        claim(path);
    };
    if (keepsFilm)
        claimFilm(film.film.empty() ? film.resume : film.film);
    if (!options.statsFile.empty())
        claim(options.statsFile);
    const PreviewInterval& preview = options.previewInterval;
    if (options.outputs.empty() && options.previewFile.empty() &&
        (preview.samples > 0 || preview.seconds > 0.0))
        throw UsageError("--preview-every has no picture to write; name one with --preview-file");
    if (!options.previewFile.empty() &&
        (options.outputs.empty() || options.previewFile != options.outputs.front()))
        claimPicture(options.previewFile);
}

} // namespace calotype
