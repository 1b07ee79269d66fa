#include "cli/picture_writer.h"

#include <cstdio>
#include <exception>

#include "base/error.h"
#include "cli/exr_metadata.h"
#include "film/error_estimate.h"
#include "film/write_image.h"

namespace calotype {

void PictureWriter::writeOutputs(Session& session) const {
    if (options_.outputs.empty())
        return;
    const Contents contents = contentsOf(session);
    std::exception_ptr firstError;
    for (const std::string& path : options_.outputs) {
        try {
            write(path, contents);
        } catch (const OutputError&) {
            firstError = firstError ? firstError : std::current_exception();
        }
    }
    if (firstError)
        std::rethrow_exception(firstError);
}

void PictureWriter::writePreview(Session& session) const {
    try {
        write(options_.previewFile.empty() ? options_.outputs.front() : options_.previewFile,
              contentsOf(session));
    } catch (const OutputError& error) {
        std::fprintf(stderr, "calotype: warning: %s\n", error.what());
    }
}

PictureWriter::Contents PictureWriter::contentsOf(Session& session) const {
    Contents contents{session.picture(), {}, session.totals()};
    if (options_.layers.errors)
        contents.errors = session.pixelErrors();
    return contents;
}

void PictureWriter::write(const std::string& path, const Contents& contents) const {
    const ExrLayers layers{firstHits_.pixels.empty() ? nullptr : &firstHits_,
                           options_.layers.firstHits, contents.errors};
    writeImage(path, contents.picture, options_.display,
               exrMetadata(label_, contents.totals.samplesPerPixel, contents.totals.seconds),
               layers);
}

} // namespace calotype
