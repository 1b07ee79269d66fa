#pragma once

#include <filesystem>
#include <optional>
#include <utility>
#include <vector>

#include "engine/mattes.h"
#include "engine/output_options.h"
#include "engine/picture_denoiser.h"
#include "film/film_file.h"
#include "image/features.h"
#include "image/first_hit.h"
#include "image/picture.h"
#include "render/session.h"

namespace calotype {

/// Writes the pictures of a render, at the end and as previews.
class PictureWriter {
public:
    /// The sources of layers are empty where there are no such layers. The options, the label and
    /// the sources must outlive this object. A picture whose folder has no room is kept in one of
    /// `spareFolders`.
    PictureWriter(const OutputOptions& options, const FilmLabel& label,
                  const FirstHitImage& firstHits, const FeatureImage& features,
                  const Mattes& mattes, std::vector<std::filesystem::path> spareFolders)
        : options_(options), label_(label), firstHits_(firstHits), features_(features),
          mattes_(mattes), spareFolders_(std::move(spareFolders)) {}

    /// Writes every output that can be written, then throws OutputError with all failures, and
    /// where those pictures are kept. `clean`, if there is one, is the picture after denoising;
    /// `display` takes the place of that of the options.
    void writeOutputs(Session& session, const std::optional<CleanPicture>& clean,
                      const DisplayTransform& display) const;

    /// Throws OutputError. `clean` is the picture so far after denoising, if it is denoised.
    void writePreview(Session& session, const std::optional<CleanPicture>& clean) const;

private:
    /// The picture so far, with its layers and metadata.
    Picture pictureOf(Session& session, const std::optional<CleanPicture>& clean) const;

    const OutputOptions& options_;
    const FilmLabel& label_;
    const FirstHitImage& firstHits_;
    const FeatureImage& features_;
    const Mattes& mattes_;
    std::vector<std::filesystem::path> spareFolders_;
};

} // namespace calotype
