#include "settings/setting_rows.h"

#include <cmath>
#include <limits>
#include <optional>

#include "image/image.h"
#include "settings/limits.h"
#include "settings/setting_kinds.h"
#include "settings/value_text.h"
#include "shared/limits.h"

namespace calotype {
namespace {

using Json = nlohmann::ordered_json;

void addPicture(std::vector<Setting>& rows) {
    static_assert(kLargestPictureSide == 65535, "as the text says");
    rows.push_back({.name = "size",
                    .type = "WxH",
                    .help = "Size of the picture in pixels (default: the scene's)",
                    .expected = "WIDTHxHEIGHT in pixels from 1 to 65535, such as 640x480",
                    .group = SettingGroup::Picture,
                    .commands = kRenderCommand | kStudyCommand,
                    .changesSamples = true,
                    .isOfScene = true,
                    .read =
                        [](std::string_view text, RenderSettings& settings) {
                            const auto sides = parseList(text, 'x', 2);
                            const auto isValid = [](uint32_t side) {
                                return side >= 1 && side <= kLargestPictureSide;
                            };
                            if (!sides || !isValid((*sides)[0]) || !isValid((*sides)[1]))
                                return false;
                            settings.width = (*sides)[0];
                            settings.height = (*sides)[1];
                            return true;
                        },
                    .print =
                        [](const RenderSettings& settings) {
                            return std::to_string(settings.width) + "x" +
                                   std::to_string(settings.height);
                        },
                    .value =
                        [](const RenderSettings& settings) {
                            return Json({settings.width, settings.height});
                        }});
    rows.push_back(
        {.name = "crop",
         .type = "X,Y,W,H",
         .help = "Render only this part, in pixels from the top left (default: all)",
         .expected = "X,Y,WIDTH,HEIGHT in pixels from the top left, such as 100,50,64,64",
         .group = SettingGroup::Picture,
         .changesSamples = true,
         .isOfScene = true,
         .read =
             [](std::string_view text, RenderSettings& settings) {
                 const auto numbers = parseList(text, ',', 4);
                 if (!numbers || (*numbers)[2] < 1 || (*numbers)[3] < 1)
                     return false;
                 settings.crop = {(*numbers)[0], (*numbers)[1], (*numbers)[2], (*numbers)[3]};
                 return true;
             },
         .print =
             [](const RenderSettings& settings) {
                 const Crop& crop = settings.crop;
                 return std::to_string(crop.x) + "," + std::to_string(crop.y) + "," +
                        std::to_string(crop.width) + "," + std::to_string(crop.height);
             },
         .value =
             [](const RenderSettings& settings) {
                 const Crop& crop = settings.crop;
                 return Json({crop.x, crop.y, crop.width, crop.height});
             }});
    rows.push_back(
        flag({.name = "transparent",
              .help = "Hide the background from the camera: it lights the scene, and the picture "
                      "has an alpha channel (default: as the scene says)",
              .group = SettingGroup::Picture,
              .changesSamples = true}, // not isOfScene: films without it show the background
             [](auto& settings) -> auto& { return settings.transport.hidesBackground; }));
    static constexpr Named<DenoiserKind> kDenoisers[] = {
        named(DenoiserKind::Off), named(DenoiserKind::Oidn), named(DenoiserKind::Statistical)};
    rows.push_back(
        choice({.name = "denoise",
                .help = "Remove the noise of the finished picture, and state its error: "
                        "off (default, unless the scene says otherwise), oidn (Open Image "
                        "Denoise 2), or statistical, which mixes only pixels whose "
                        "difference may be noise",
                .group = SettingGroup::Picture,
                .commands = kRenderCommand | kMergeCommand | kDenoiseCommand,
                .isOfScene = true},
               kDenoisers, [](auto& settings) -> auto& { return settings.denoiser; }));
}

void addEnd(std::vector<Setting>& rows) {
    rows.push_back(wholeNumber({.name = "spp",
                                .help = "Samples per pixel (default: the scene's)",
                                .group = SettingGroup::End,
                                .commands = kRenderCommand | kBenchCommand,
                                .isOfScene = true},
                               1, kMostSamplesPerPixel,
                               [](auto& settings) -> auto& { return settings.samplesPerPixel; }));
    rows.push_back(
        {.name = "target_error",
         .type = "X",
         .help = "Render until the relative error, at 95 % confidence, is at most this, e.g. 0.02; "
                 "with --denoise, that of the picture after denoising",
         .expected = "a relative error between 0 and 1, such as 0.02 for 2 %",
         .group = SettingGroup::End,
         .read =
             [](std::string_view text, RenderSettings& settings) {
                 settings.targetError = parseNumber<double>(text);
                 return settings.targetError && *settings.targetError > 0.0 &&
                        *settings.targetError < 1.0;
             },
         .print =
             [](const RenderSettings& settings) {
                 return settings.targetError ? shortestText(*settings.targetError) : "none";
             },
         .value = [](const RenderSettings& settings) { return orNull(settings.targetError); }});
    rows.push_back(
        {.name = "time",
         .type = "30s",
         .help = "Render until so much time has passed since the start: 30s, 5m, 2h",
         .expected = "a time above 0, such as 30s, 5m or 2h",
         .group = SettingGroup::End,
         .read =
             [](std::string_view text, RenderSettings& settings) {
                 settings.seconds = parseSeconds(text);
                 return settings.seconds.has_value();
             },
         .print =
             [](const RenderSettings& settings) {
                 return settings.seconds ? shortestText(*settings.seconds) + "s" : "none";
             },
         .value = [](const RenderSettings& settings) { return orNull(settings.seconds); }});
    static_assert(shared::kSamplesPerBlock == 16 && kMostSamplesPerPixel == 67'108'864,
                  "as the texts say");
    rows.push_back(
        {.name = "samples",
         .type = "FIRST:END",
         .help = "Render these samples of each pixel only, multiples of 16",
         .expected = "FIRST:END with FIRST below END, both multiples of 16 up to 67108864, such "
                     "as 64:128",
         .group = SettingGroup::End,
         .isOfScene = true,
         .read =
             [](std::string_view text, RenderSettings& settings) {
                 const auto numbers = parseList(text, ':', 2);
                 const auto isBorder = [](uint32_t n) {
                     return n % shared::kSamplesPerBlock == 0 && n <= kMostSamplesPerPixel;
                 };
                 if (!numbers || !isBorder((*numbers)[0]) || !isBorder((*numbers)[1]) ||
                     (*numbers)[0] >= (*numbers)[1])
                     return false;
                 settings.firstSample = (*numbers)[0];
                 settings.samplesPerPixel = (*numbers)[1] - (*numbers)[0];
                 return true;
             },
         .print =
             [](const RenderSettings& settings) {
                 return std::to_string(settings.firstSample) + ":" +
                        std::to_string(settings.firstSample + settings.samplesPerPixel);
             },
         .value =
             [](const RenderSettings& settings) {
                 return Json(
                     {settings.firstSample, settings.firstSample + settings.samplesPerPixel});
             }});
}

/// Settings of the samples and of the speed.
void addSampling(std::vector<Setting>& rows) {
    rows.push_back(
        flag({.name = "adaptive",
              .help = "Give more samples to pixels of more error; --spp is the mean then",
              .group = SettingGroup::Sampling},
             [](auto& settings) -> auto& { return settings.isAdaptive; }));
    static constexpr Named<Sampler> kSamplers[] = {named(Sampler::Independent),
                                                   named(Sampler::Sobol)};
    rows.push_back(
        choice({.name = "sampler",
                .help = "How random numbers are drawn: each for itself (independent), or in pairs "
                        "that fill the square evenly (sobol, the default)",
                .group = SettingGroup::Sampling,
                .commands = kRenderCommand | kBenchCommand,
                .changesSamples = true},
               kSamplers, [](auto& settings) -> auto& { return settings.sampler; }));
    rows.push_back(wholeNumber({.name = "seed",
                                .help = "Seed of the random numbers (default: the scene's)",
                                .group = SettingGroup::Sampling,
                                .changesSamples = true,
                                .isOfScene = true},
                               0, std::numeric_limits<uint32_t>::max(),
                               [](auto& settings) -> auto& { return settings.seed; }));
    static constexpr Named<std::optional<BvhBuilder>> kBuilders[] = {
        {"auto", std::nullopt}, named(BvhBuilder::Median), named(BvhBuilder::Sah)};
    rows.push_back(choice(
        {.name = "bvh",
         .help = "How the BVH is built: median (quick to build), sah (quick to traverse), or auto, "
                 "the quickest for the number of samples (default)",
         .group = SettingGroup::Sampling,
         .commands = kRenderCommand | kBenchCommand | kInfoCommand,
         .changesSamples = true},
        kBuilders, [](auto& settings) -> auto& { return settings.bvh; }));
    rows.push_back(flag({.name = "everything",
                         .help = "Compile the whole kernel, whatever part of it the scene needs",
                         .group = SettingGroup::Sampling,
                         .commands = kBenchCommand},
                        [](auto& settings) -> auto& { return settings.compilesEverything; }));
}

/// Settings of light transport.
void addLight(std::vector<Setting>& rows) {
    rows.push_back(
        onOff({.name = "roulette",
               .help = "End paths that carry little light early, by chance (on, the default)",
               .group = SettingGroup::Light,
               .changesSamples = true},
              [](auto& settings) -> auto& { return settings.transport.usesRoulette; }));
    rows.push_back(onOff(
        {.name = "mis",
         .help = "Share light between sampling lights and sampling surfaces (on, the default), or "
                 "leave it to sampling lights (off)",
         .group = SettingGroup::Light,
         .changesSamples = true},
        [](auto& settings) -> auto& { return settings.transport.usesMis; }));
    rows.push_back(wholeNumber(
        {.name = "max_bounces",
         .help = "Scattering events along a path, at most; 0 shows emitters only (default: the "
                 "scene's)",
         .group = SettingGroup::Light,
         .changesSamples = true,
         .isOfScene = true},
        0, kMostBounces, [](auto& settings) -> auto& { return settings.maxBounces; }));
    rows.push_back(
        {.name = "clamp_indirect",
         .type = "X|off",
         .help = "Most radiance of one contribution of indirect light; removes fireflies and some "
                 "light (default: off)",
         .expected = "a radiance above 0, such as 10, or off",
         .group = SettingGroup::Light,
         .changesSamples = true,
         .read =
             [](std::string_view text, RenderSettings& settings) {
                 const auto limit = text == "off" ? TransportSettings().indirectClamp
                                                  : parseNumber<float>(text).value_or(0.0f);
                 settings.transport.indirectClamp = limit;
                 return limit > 0.0f && (text == "off" || std::isfinite(limit));
             },
         .print =
             [](const RenderSettings& settings) {
                 const TransportSettings& transport = settings.transport;
                 return transport.clampsIndirect() ? shortestText(transport.indirectClamp) : "off";
             },
         .value =
             [](const RenderSettings& settings) {
                 const TransportSettings& transport = settings.transport;
                 return transport.clampsIndirect() ? Json(transport.indirectClamp) : Json(nullptr);
             }});
    static constexpr Named<LightChoice> kLightChoices[] = {
        named(LightChoice::Power), named(LightChoice::Tree), named(LightChoice::Uniform),
        named(LightChoice::All)};
    rows.push_back(choice(
        {.name = "light_choice",
         .help = "Which light is sampled at each event: one by its power, one by what it may "
                 "contribute there (a tree of lights), one at random, or, with --device reference, "
                 "all (default: power; tree if more than 16 primitives emit)",
         .group = SettingGroup::Light,
         .changesSamples = true}, // not isOfScene: films without it are by power
        kLightChoices, [](auto& settings) -> auto& { return settings.transport.lightChoice; }));
    static constexpr Named<std::optional<TextureFilter>> kFilters[] = {
        {"scene", std::nullopt}, named(TextureFilter::Bilinear), named(TextureFilter::Nearest)};
    rows.push_back(choice({.name = "texture_filter",
                           .help = "Filter of all textures (default: as the scene says)",
                           .group = SettingGroup::Light,
                           .changesSamples = true},
                          kFilters,
                          [](auto& settings) -> auto& { return settings.textureFilter; }));
}

} // namespace

std::vector<Setting> makeSettingRows() {
    std::vector<Setting> rows;
    addPicture(rows);
    addEnd(rows);
    addSampling(rows);
    addLight(rows);
    return rows;
}

} // namespace calotype
