#include "engine/picture_writer.h"

#include <string>

#include "base/output_failures.h"
#include "engine/exr_metadata.h"
#include "engine/film_picture.h"
#include "engine/spare_file.h"
#include "film/develop.h"
#include "film/write_picture.h"

namespace calotype {

void PictureWriter::writeOutputs(Session& session, const std::optional<CleanPicture>& clean,
                                 const DisplayTransform& display) const {
    if (options_.pictures.empty())
        return;
    const Picture picture = pictureOf(session, clean);
    OutputFailures failures;
    for (const std::string& output : options_.pictures)
        failures.attempt([&] {
            SpareFile(output, spareFolders_).write("the picture", [&](const auto& path) {
                writePicture(path, picture, display);
            });
        });
    failures.throwIfAny();
}

void PictureWriter::writePreview(Session& session, const std::optional<CleanPicture>& clean) const {
    writePicture(options_.previewFile.empty() ? options_.pictures.front() : options_.previewFile,
                 pictureOf(session, clean), options_.display);
}

Picture PictureWriter::pictureOf(Session& session, const std::optional<CleanPicture>& clean) const {
    const auto makeChannels = [&](const Layer& layer) {
        switch (layer.source) {
        case LayerSource::FirstHit:
            return channelsOf(layer, firstHits_);
        case LayerSource::Averaged:
            return channelsOf(layer, features_);
        case LayerSource::Mattes:
            return mattes_.channelsOf(layer);
        case LayerSource::Replicas:
            break;
        }
        return session.channelsOf(layer);
    };
    Picture picture =
        develop(clean ? clean->color : session.picture(), options_.layers, makeChannels);
    picture.setAlpha(session.alpha());
    mattes_.describe(picture);
    describe(picture, label_, session.totals().samplesPerPixel);
    if (clean)
        describeClean(*clean, session.picture(), picture);
    return picture;
}

} // namespace calotype
