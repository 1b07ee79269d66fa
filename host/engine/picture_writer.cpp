#include "engine/picture_writer.h"

#include "base/output_failures.h"
#include "engine/exr_metadata.h"
#include "engine/spare_file.h"
#include "film/develop.h"
#include "film/write_picture.h"

namespace calotype {

void PictureWriter::writeOutputs(Session& session) const {
    if (options_.pictures.empty())
        return;
    const Picture picture = pictureOf(session);
    OutputFailures failures;
    for (const std::string& output : options_.pictures)
        failures.attempt([&] {
            SpareFile(output, spareFolders_).write("the picture", [&](const auto& path) {
                writePicture(path, picture, options_.display);
            });
        });
    failures.throwIfAny();
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
    describe(picture, label_, session.totals().samplesPerPixel);
    return picture;
}

} // namespace calotype
