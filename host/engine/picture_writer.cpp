#include "engine/picture_writer.h"

#include <string>
#include <utility>
#include <vector>

#include "base/output_failures.h"
#include "engine/exr_metadata.h"
#include "engine/spare_file.h"
#include "film/develop.h"
#include "film/write_picture.h"

namespace calotype {

namespace {

/// The picture as the samples are, as a layer.
void addNoisyLayer(const Image& noisy, Picture& picture) {
    for (int i = 0; i < 3; ++i) {
        std::vector<float> values;
        values.reserve(noisy.pixels.size());
        for (const glm::vec3& pixel : noisy.pixels)
            values.push_back(pixel[i]);
        picture.channels.push_back({std::string("noisy.") + "RGB"[i], std::move(values)});
    }
}

void describeClean(const CleanPicture& clean, Picture& picture) {
    picture.metadata.push_back({"denoiser", clean.denoiser});
    if (clean.error) {
        picture.metadata.push_back({"denoisedError", clean.error->relative});
        picture.metadata.push_back({"denoisedBound", clean.error->bound});
    }
}

} // namespace

void PictureWriter::writeOutputs(Session& session, const std::optional<CleanPicture>& clean) const {
    if (options_.pictures.empty())
        return;
    const Picture picture = pictureOf(session, clean);
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
                 pictureOf(session, {}), options_.display);
}

Picture PictureWriter::pictureOf(Session& session, const std::optional<CleanPicture>& clean) const {
    const auto makeChannels = [&](const Layer& layer) {
        switch (layer.source) {
        case LayerSource::FirstHit:
            return channelsOf(layer, firstHits_);
        case LayerSource::Averaged:
            return channelsOf(layer, features_);
        case LayerSource::Replicas:
            break;
        }
        return session.channelsOf(layer);
    };
    Picture picture = develop(clean ? clean->color : session.picture(), options_.layers,
                              options_.stages, makeChannels);
    describe(picture, label_, session.totals().samplesPerPixel);
    if (clean) {
        addNoisyLayer(session.picture(), picture);
        describeClean(*clean, picture);
    }
    return picture;
}

} // namespace calotype
