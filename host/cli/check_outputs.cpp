#include "cli/check_outputs.h"

#include <algorithm>
#include <filesystem>

#include "base/error.h"
#include "engine/render_job.h"
#include "engine/scene_settings.h"
#include "image/image_format.h"
#include "image/layers.h"

namespace calotype {
namespace {

bool namesExr(const std::string& path) { return imageFormatOf(path) == ImageFormat::Exr; }

bool isPicture(const std::string& path) { return imageFormatOf(path).has_value(); }

void requireExrFor(const LayerList& layers, const std::vector<std::string>& outputs) {
    if (!layers.empty() && std::ranges::none_of(outputs, namesExr))
        throw UsageError("--aov writes layers of EXR files, and no output is one; add -o FILE.exr");
}

} // namespace

OutputClaims checkOutputs(const RenderOptions& options) {
    OutputClaims claims;
    claims.reserve(options.scene.path);
    const FilmOptions& film = options.film;
    const OutputOptions& output = options.output;
    if (!film.film.empty() && !isSameFile(film.resume, film.film)) // else it is an output
        claims.reserve(film.resume);
    if (options.settings.has("adaptive") && options.settings.has("samples"))
        throwSamplesOfAdaptive();
    if (output.pictures.empty() && !film.keepsFilm())
        throw UsageError(
            "there is nothing to write; name a picture with -o, or a film with --film");
    RenderJob job;
    options.settings.applyTo(job.settings);
    job.film = film;
    job.output = output;
    requireConsistent(job);
    for (const std::string& path : output.pictures)
        claims.claimPicture(path);
    requireExrFor(output.layers, output.pictures);
    if (film.checkpointSeconds && !film.keepsFilm())
        throw UsageError("--checkpoint is how often a film is kept, and none is; add --film FILE");
    if (film.overwrites && film.film.empty())
        throw UsageError("--overwrite begins the film of --film anew, and there is none; add "
                         "--film FILE, or leave it out");
    if (film.overwrites && isSameFile(film.resume, film.film))
        throw UsageError("--overwrite begins the film anew, and --resume continues it; leave out "
                         "one of them");
    if (film.keepsFilm())
        claims.claimFilm(film.path());
    if (!output.statsFile.empty())
        claims.claim(output.statsFile);
    const PreviewInterval& interval = output.previewInterval;
    if (!output.previewFile.empty() && interval.samples == 0 && !(interval.seconds > 0.0))
        throw UsageError("--preview-file is where previews go, and none is written; add "
                         "--preview-every 10s, or leave it out");
    if (!output.previewFile.empty() &&
        (output.pictures.empty() || output.previewFile != output.pictures.front()))
        claims.claimPicture(output.previewFile);
    return claims;
}

OutputClaims checkOutputs(const DenoiseOptions& options) {
    RenderSettings settings;
    options.settings.applyTo(settings);
    if (options.settings.has("denoise") && settings.denoiser == DenoiserKind::Off)
        throw UsageError("--denoise off leaves this command nothing to do; name oidn or "
                         "statistical");
    OutputClaims claims;
    claims.reserve(options.input);
    for (const std::string& path : options.outputs)
        claims.claimPicture(path);
    if (!options.statsFile.empty())
        claims.claim(options.statsFile);
    return claims;
}

OutputClaims checkOutputs(const MergeOptions& options) {
    OutputClaims claims;
    claims.reserve(options.films);
    for (const std::string& path : options.outputs)
        if (isPicture(path))
            claims.claimPicture(path);
        else if (const auto extension = std::filesystem::path(path).extension();
                 extension.empty() || extension == ".film")
            claims.claimFilm(path);
        else
            throw UsageError("'" + path +
                             "' is neither a film (.film, or no extension) nor a "
                             "picture (" +
                             std::string(kImageExtensions) + ")");
    RenderSettings settings;
    options.settings.applyTo(settings);
    if (settings.denoiser != DenoiserKind::Off && std::ranges::none_of(options.outputs, isPicture))
        throw UsageError("--denoise is for pictures, and no output is one; add -o FILE.exr");
    if (settings.denoiser == DenoiserKind::Off && options.threads > 0)
        throw UsageError("--threads is for the denoiser, and there is none; add --denoise oidn, or "
                         "leave it out");
    requireExrFor(options.layers, options.outputs);
    if (std::ranges::any_of(options.layers, [](const Layer* layer) {
            return layer->source != LayerSource::Replicas;
        }))
        throw UsageError(
            "films hold samples of light alone; of the layers of --aov, merge writes " +
            namesOf(layersOfFilms()));
    return claims;
}

} // namespace calotype
