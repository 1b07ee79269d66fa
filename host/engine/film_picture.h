#pragma once

#include <optional>
#include <string>

#include "engine/picture_denoiser.h"
#include "film/film_file.h"
#include "image/layer.h"
#include "image/picture.h"

namespace calotype {

/// Denoises a film. Throws SceneError at `path` with what to do if it lacks the colours of
/// replicas, and Error. `onProgress` as for PictureDenoiser::run.
CleanPicture denoiseFilm(const PictureDenoiser& denoiser, const std::string& path,
                         const KeptFilm& kept, uint32_t threads,
                         const PictureDenoiser::OnProgress& onProgress);

/// A warning for denoiseFilm, with what to do, if the film lacks the features; empty if it does
/// not, or cannot be denoised.
std::string featureWarning(const std::string& path, const KeptFilm& kept);

/// The picture of a film, or of `clean`, which was made of it, with layers of layersOfFilms() and
/// its metadata.
Picture pictureOf(const KeptFilm& kept, const LayerList& layers,
                  const std::optional<CleanPicture>& clean);

/// Adds to a denoised picture what it was before, as the layer "noisy", and metadata that say how
/// it was denoised and how wrong it is.
void describeClean(const CleanPicture& clean, const Image& noisy, Picture& picture);

} // namespace calotype
