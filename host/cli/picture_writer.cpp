#include "cli/picture_writer.h"

#include <cstdio>
#include <exception>

#include "base/error.h"
#include "cli/exr_metadata.h"
#include "film/develop.h"
#include "film/write_picture.h"

namespace calotype {

void PictureWriter::writeOutputs(Session& session) const {
    if (options_.outputs.empty())
        return;
    const Picture picture = pictureOf(session);
    std::exception_ptr firstError;
    for (const std::string& path : options_.outputs) {
        try {
            write(path, picture);
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
              pictureOf(session));
    } catch (const OutputError& error) {
        std::fprintf(stderr, "calotype: warning: %s\n", error.what());
    }
}

Picture PictureWriter::pictureOf(Session& session) const {
    const auto makeChannels = [&](const Layer& layer) {
        return layer.source == LayerSource::FirstHit ? channelsOf(layer, firstHits_)
                                                     : session.channelsOf(layer);
    };
    Picture picture = develop(session.picture(), options_.layers, options_.stages, makeChannels);
    describe(picture, label_, session.totals().samplesPerPixel, session.totals().seconds);
    return picture;
}

void PictureWriter::write(const std::string& path, const Picture& picture) const {
    writePicture(path, picture, options_.display);
}

} // namespace calotype
