#pragma once

#include <utility>

#include "engine/output_options.h"
#include "film/film_file.h"
#include "image/first_hit.h"
#include "image/picture.h"
#include "render/session.h"

namespace calotype {

/// Writes a render's pictures, in the end and on the way.
class PictureWriter {
public:
    /// `firstHits` are what the layers of first hits show, empty where none is wanted. The options
    /// and the label must outlive this.
    PictureWriter(const OutputOptions& options, const FilmLabel& label, FirstHitImage firstHits)
        : options_(options), label_(label), firstHits_(std::move(firstHits)) {}

    /// Writes every output that can be written, then throws what went wrong first, if anything.
    void writeOutputs(Session& session) const;

    /// Throws OutputError.
    void writePreview(Session& session) const;

private:
    /// The picture so far, with its layers and metadata.
    Picture pictureOf(Session& session) const;

    const OutputOptions& options_;
    const FilmLabel& label_;
    FirstHitImage firstHits_;
};

} // namespace calotype
