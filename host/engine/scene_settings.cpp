#include "engine/scene_settings.h"

#include <string>

#include "base/error.h"
#include "denoise/cross_validation.h"
#include "engine/devices.h"
#include "image/image.h"
#include "scene/light_cluster.h"
#include "settings/limits.h"
#include "settings/settings_table.h"
#include "shared/limits.h"

namespace calotype {
namespace {

void requireSide(uint32_t side) {
    if (side < 1 || side > kLargestPictureSide)
        throw SettingError("size", "is " + std::to_string(side) + ", and not from 1 to " +
                                       std::to_string(kLargestPictureSide));
}

/// What the rows of the table say themselves.
void requireWhatRowsSay(const RenderSettings& settings) {
    for (const Setting& row : settingsTable())
        if (const std::string fault = row.fault ? row.fault(settings) : ""; !fault.empty())
            throw SettingError(row.name, fault);
}

void requireCropInside(const RenderSettings& settings) {
    const Crop& crop = settings.crop;
    if (crop.width == 0 || crop.height == 0)
        throw SettingError("crop", "is empty");
    if (crop.x >= settings.width || crop.width > settings.width - crop.x ||
        crop.y >= settings.height || crop.height > settings.height - crop.y)
        throw SettingError("crop", "reaches beyond the picture of " +
                                       std::to_string(settings.width) + "x" +
                                       std::to_string(settings.height) + " pixels");
}

} // namespace

RenderSettings defaultSettings(const Scene& scene) {
    RenderSettings settings;
    settings.width = scene.film.width;
    settings.height = scene.film.height;
    settings.crop = {0, 0, settings.width, settings.height};
    settings.samplesPerPixel = scene.render.samplesPerPixel;
    settings.maxBounces = scene.render.maxBounces;
    settings.seed = scene.render.seed;
    settings.denoiser = scene.render.denoiser;
    settings.transport.hidesBackground = scene.render.hidesBackground;
    settings.transport.lightChoice = defaultLightChoice(scene);
    return settings;
}

LightChoice defaultLightChoice(const Scene& scene) {
    constexpr uint32_t kMostByPower = 16; // primitives
    return hasMorePrimitiveLightsThan(kMostByPower, scene) ? LightChoice::Tree : LightChoice::Power;
}

void requireKnownTo(const DeviceOptions& device, const RenderSettings& settings) {
    if (settings.transport.lightChoice == LightChoice::All && !isReference(device))
        throw SettingError("light_choice",
                           "all is known to the reference tracer only (--device reference)");
}

void throwSamplesOfAdaptive() {
    throw SettingError("adaptive", "decides on the samples of each pixel itself; leave out "
                                   "--samples, or --adaptive");
}

void requireRenderable(const RenderSettings& settings, const DeviceOptions& device) {
    requireSide(settings.width);
    requireSide(settings.height);
    requireCropInside(settings);
    requireWhatRowsSay(settings);
    if (settings.firstSample % shared::kSamplesPerBlock != 0 ||
        settings.firstSample > kMostSamplesPerPixel - settings.samplesPerPixel)
        throw SettingError("samples", "begin at no multiple of " +
                                          std::to_string(shared::kSamplesPerBlock) +
                                          ", or end too late");
    if (!(settings.transport.indirectClamp > 0.0f))
        throw SettingError("clamp_indirect", "is not above 0");
    if (settings.targetError && !(*settings.targetError > 0.0 && *settings.targetError < 1.0))
        throw SettingError("target_error", "is not between 0 and 1");
    if (settings.seconds && !(*settings.seconds > 0.0 && *settings.seconds <= kMostSeconds))
        throw SettingError("time", "is not above 0, or is above 1e9 seconds");
    if (settings.isAdaptive && settings.firstSample != 0)
        throwSamplesOfAdaptive();
    if (settings.targetError && settings.denoiser != DenoiserKind::Off &&
        !canStateError(settings.crop.width, settings.crop.height))
        throw SettingError("target_error",
                           "cannot be judged after denoising: the picture has fewer "
                           "than 8 tiles of 16 x 16 pixels; render a larger one, "
                           "or without --denoise");
    requireKnownTo(device, settings);
}

void requireConsistent(const RenderJob& job) {
    const OutputOptions& output = job.output;
    const PreviewInterval& preview = output.previewInterval;
    if (job.settings.isAdaptive && job.film.keepsFilm())
        throw UsageError("films have as many samples in every pixel, and --adaptive has not; "
                         "leave out one of them");
    if (output.pictures.empty() && output.previewFile.empty() &&
        (preview.samples > 0 || preview.seconds > 0.0))
        throw UsageError("--preview-every has no picture to write; name one with --preview-file");
}

} // namespace calotype
