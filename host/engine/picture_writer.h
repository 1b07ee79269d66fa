#pragma once

#include <filesystem>
#include <utility>
#include <vector>

#include "engine/output_options.h"
#include "film/film_file.h"
#include "image/first_hit.h"
#include "image/picture.h"
#include "render/session.h"

namespace calotype {

/// Writes the pictures of a render, at the end and as previews.
class PictureWriter {
public:
    /// `firstHits` is the source of the first-hit layers, empty if there are none. The options and
    /// the label must outlive this object. A picture whose folder has no room is kept in one of
    /// `spareFolders`.
    PictureWriter(const OutputOptions& options, const FilmLabel& label, FirstHitImage firstHits,
                  std::vector<std::filesystem::path> spareFolders)
        : options_(options), label_(label), firstHits_(std::move(firstHits)),
          spareFolders_(std::move(spareFolders)) {}

    /// Writes every output that can be written, then throws OutputError with all failures, and
    /// where those pictures are kept.
    void writeOutputs(Session& session) const;

    /// Throws OutputError.
    void writePreview(Session& session) const;

private:
    /// The picture so far, with its layers and metadata.
    Picture pictureOf(Session& session) const;

    const OutputOptions& options_;
    const FilmLabel& label_;
    FirstHitImage firstHits_;
    std::vector<std::filesystem::path> spareFolders_;
};

} // namespace calotype
