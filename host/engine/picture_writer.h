#pragma once

#include <utility>

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
    /// the label must outlive this object.
    PictureWriter(const OutputOptions& options, const FilmLabel& label, FirstHitImage firstHits)
        : options_(options), label_(label), firstHits_(std::move(firstHits)) {}

    /// Writes every output that can be written, then throws the first error, if there was one.
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
