#include "engine/film_picture.h"

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "base/available_memory.h"
#include "base/error.h"
#include "denoise/film_view.h"
#include "engine/denoising_memory.h"
#include "engine/exr_metadata.h"
#include "film/develop.h"
#include "image/denoised_mark.h"

namespace calotype {

CleanPicture denoiseFilm(const PictureDenoiser& denoiser, const std::string& path,
                         const KeptFilm& kept, uint32_t threads,
                         const PictureDenoiser::OnProgress& onProgress) {
    if (kept.film.detail() != ReplicaDetail::Color)
        throw SceneError(
            path, "the film cannot be denoised: it was rendered without --denoise, and lacks the "
                  "colours of replicas; render it with --denoise from the start, or make an .exr "
                  "of it with calotype merge and denoise that, whose error is not stated then");
    if (kept.film.blocks().empty())
        throw SceneError(path, "the film cannot be denoised: it has no samples; render more");
    if (const std::string why = denoiser.whyTooFewSamples(kept.film); !why.empty())
        throw SceneError(path, "the film cannot be denoised: " + why);
    const uint64_t bytes =
        denoisingBytes(denoiser.kind(), kept.film.pixelCount(), FilmView(kept.film).replicaCount());
    if (const std::string why = whyNoRoom(bytes, availableMemory()); !why.empty())
        throw SceneError(path, "the film cannot be denoised here: that " + why +
                                   "; denoise it on a machine with more memory");
    return denoiser.run(kept.film, kept.film.picture(), kept.features, threads, onProgress);
}

std::string featureWarning(const std::string& path, const KeptFilm& kept) {
    if (kept.features || kept.film.detail() != ReplicaDetail::Color)
        return "";
    return path +
           " lacks the albedo and normals of its pixels, so that edges and textures may be "
           "lost; calotype render SCENE --film " +
           path + " --denoise oidn -o FILE finds them";
}

Picture pictureOf(const KeptFilm& kept, const LayerList& layers,
                  const std::optional<CleanPicture>& clean) {
    Picture picture = develop(clean ? clean->color : kept.film.picture(), layers,
                              [&](const Layer& layer) { return channelsOf(layer, kept.film); });
    picture.setAlpha(kept.film.alpha());
    describe(picture, kept.label, kept.film.samplesPerPixel());
    if (clean)
        describeClean(*clean, kept.film.picture(), picture);
    return picture;
}

void describeClean(const CleanPicture& clean, const Image& noisy, Picture& picture) {
    for (int i = 0; i < 3; ++i) {
        std::vector<float> values;
        values.reserve(noisy.pixels.size());
        for (const glm::vec3& pixel : noisy.pixels)
            values.push_back(pixel[i]);
        picture.channels.push_back({std::string("noisy.") + "RGB"[i], std::move(values)});
    }
    DenoisedMark mark{clean.denoiser, {}, {}};
    if (clean.error) {
        mark.error = clean.error->relative;
        mark.bound = clean.error->bound;
    }
    addMark(mark, picture.metadata);
}

} // namespace calotype
