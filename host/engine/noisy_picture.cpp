#include "engine/noisy_picture.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "base/error.h"
#include "base/file_kind.h"
#include "engine/film_picture.h"
#include "image/check_size.h"
#include "image/denoised_mark.h"
#include "image/exr.h"
#include "image/exr_check.h"
#include "image/layers.h"
#include "image/read_image.h"

namespace calotype {
namespace {

const std::vector<std::string> kNoisyChannels = {"noisy.R", "noisy.G", "noisy.B"};

void requireExr(const std::filesystem::path& path) {
    const std::string signature = signatureOf(path);
    if (isExr(signature))
        return;
    const std::string_view kind = fileKind(signature);
    throw SceneError(path.string(),
                     "the file is " +
                         (kind.empty() ? "none that can be denoised" : std::string(kind)) +
                         "; films and EXR files can be denoised");
}

/// Three channels of floats; none if the picture lacks one of them.
std::optional<Image> imageOf(const Picture& picture, const std::vector<std::string>& names) {
    Image image(picture.color.width, picture.color.height);
    for (int i = 0; i < 3; ++i) {
        const auto channel = std::ranges::find(picture.channels, names[i], &Channel::name);
        if (channel == picture.channels.end())
            return std::nullopt;
        const auto* values = std::get_if<std::vector<float>>(&channel->pixels);
        if (!values)
            return std::nullopt;
        for (size_t pixel = 0; pixel < values->size(); ++pixel)
            image.pixels[pixel][i] = (*values)[pixel];
    }
    return image;
}

/// The file of another program may have any numbers in them.
void bringIntoRange(Image& image, float least) {
    for (glm::vec3& pixel : image.pixels)
        for (int i = 0; i < 3; ++i)
            pixel[i] = std::isfinite(pixel[i]) ? std::clamp(pixel[i], least, 1.0f) : 0.0f;
}

std::optional<DenoiserFeatures> featuresOf(const Picture& picture, const char* albedoLayer,
                                           const char* normalLayer) {
    auto albedo = imageOf(picture, findLayer(albedoLayer)->channels);
    auto normal = imageOf(picture, findLayer(normalLayer)->channels);
    if (!albedo || !normal)
        return std::nullopt;
    bringIntoRange(*albedo, 0.0f);
    bringIntoRange(*normal, -1.0f);
    return DenoiserFeatures{std::move(*albedo), std::move(*normal)};
}

/// Finds the features, and warns if they are not the best.
void findFeatures(NoisyPicture& noisy, const std::string& path) {
    noisy.features = featuresOf(noisy.picture, "meanAlbedo", "meanNormal");
    if (noisy.features)
        return;
    noisy.features = featuresOf(noisy.picture, "albedo", "normal");
    if (noisy.features)
        noisy.features->areMeans = false;
    noisy.warning =
        path + " has no layers meanAlbedo and meanNormal, " +
        (noisy.features ? "and those of first hits, which are used, do not show what is in "
                          "mirrors and behind glass"
                        : "so that edges and textures may be lost") +
        "; render with --aov meanAlbedo,meanNormal";
}

/// Takes the layer "noisy" for the colour if there is one, and removes what an earlier denoiser
/// left.
void undoDenoising(Picture& picture, const std::string& path) {
    auto noisy = imageOf(picture, kNoisyChannels);
    if (!noisy && markOf(picture.metadata))
        throw SceneError(path, "the picture is denoised already, and has no layer noisy with its "
                               "samples; denoise the file that calotype wrote, or the film");
    if (noisy)
        picture.color = std::move(*noisy);
    removeMark(picture.metadata);
    std::erase_if(picture.channels, [](const Channel& channel) {
        return std::ranges::find(kNoisyChannels, channel.name) != kNoisyChannels.end();
    });
}

void requireFinite(const Image& image, const std::string& path) {
    const auto isFinite = [](const glm::vec3& pixel) {
        return std::isfinite(pixel.r) && std::isfinite(pixel.g) && std::isfinite(pixel.b);
    };
    const auto bad = std::ranges::find_if_not(image.pixels, isFinite);
    if (bad == image.pixels.end())
        return;
    const auto index = static_cast<size_t>(bad - image.pixels.begin());
    throw SceneError(path, std::to_string(std::ranges::count_if(
                               image.pixels, [&](const auto& p) { return !isFinite(p); })) +
                               " pixels are not finite, the first at (" +
                               std::to_string(index % image.width) + ", " +
                               std::to_string(index / image.width) +
                               ") from the top left; such a picture cannot be denoised");
}

} // namespace

NoisyPicture readNoisyPicture(const std::filesystem::path& path) {
    requireExr(path);
    checkArea(checkExr(path), kMostPicturePixels, "denoised", path.string());
    if (hasOtherPrimaries(path))
        throw SceneError(path.string(), "the picture has other primaries (its attribute "
                                        "chromaticities) than those of Rec. 709, in which "
                                        "pictures are denoised; convert it");
    NoisyPicture noisy{readExrPicture(path), {}, ""};
    undoDenoising(noisy.picture, path.string());
    requireFinite(noisy.picture.color, path.string());
    findFeatures(noisy, path.string());
    return noisy;
}

Picture pictureOf(NoisyPicture noisy, const CleanPicture& clean) {
    Picture picture = std::move(noisy.picture);
    const Image before = std::exchange(picture.color, clean.color);
    describeClean(clean, before, picture);
    return picture;
}

} // namespace calotype
