#include "engine/picture_writer.h"

#include <exception>

#include "base/error.h"
#include "engine/exr_metadata.h"
#include "film/develop.h"
#include "film/write_picture.h"

namespace calotype {

void PictureWriter::writeOutputs(Session& session) const {
    if (options_.pictures.empty())
        return;
    const Picture picture = pictureOf(session);
    std::exception_ptr firstError;
    for (const std::string& path : options_.pictures) {
        try {
            writePicture(path, picture, options_.display);
        } catch (const OutputError&) {
            firstError = firstError ? firstError : std::current_exception();
        }
    }
    if (firstError)
        std::rethrow_exception(firstError);
}

void PictureWriter::writePreview(Session& session) const {
    writePicture(options_.previewFile.empty() ? options_.pictures.front() : options_.previewFile,
                 pictureOf(session), options_.display);
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

} // namespace calotype
