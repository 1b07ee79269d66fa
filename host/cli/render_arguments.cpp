#include <string>

#include "cli/arguments.h"
#include "cli/parse_values.h"
#include "settings/limits.h"

namespace calotype {
namespace {

/// What ends a render.
void addGoalOptions(CLI::App& command, RenderOptions& options) {
    command.add_option("--spp", options.samplesPerPixel, "Samples per pixel")
        ->check(CLI::Range(1u, kMostSamplesPerPixel))
        ->type_name("N");
    addParsed(command, "--target-error", options.targetError, parseTargetError,
              "Render until the relative error, at 95 % confidence, is at most this, e.g. 0.02",
              "X");
    const auto parseTime = [](const std::string& text) { return parseDuration("--time", text); };
    addParsed(command, "--time", options.seconds, parseTime,
              "Render until so much time has passed since the start: 30s, 5m, 2h", "30s");
    command
        .add_flag("--adaptive", options.adapts,
                  "Give more samples to pixels of more error; --spp is the mean then")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
}

/// How light is looked for.
void addTransportOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option("--max-bounces", options.maxBounces,
                    "Scattering events along a path, at most; 0 shows emitters only")
        ->check(CLI::Range(0u, kMostBounces))
        ->type_name("N");
    TransportSettings& transport = options.transport;
    const auto parseMis = [](const std::string& text) { return parseSwitch("--mis", text); };
    addParsed(command, "--mis", transport.usesMis, parseMis,
              "Share light between sampling lights and sampling surfaces (on, the default), or "
              "leave it to sampling lights (off)",
              "on|off");
    const auto parseRoulette = [](const std::string& text) {
        return parseSwitch("--roulette", text);
    };
    addParsed(command, "--roulette", transport.usesRoulette, parseRoulette,
              "End paths that carry little light early, by chance (on, the default)", "on|off");
    addParsed(command, "--clamp-indirect", transport.indirectClamp, parseIndirectClamp,
              "Most radiance of one contribution of indirect light; takes fireflies and some light "
              "away (default: off)",
              "X|off");
    addParsed(
        command, "--light-choice", options.lightChoice, parseLightChoice,
        "Which light is sampled at each event: one by its power (default), one at random, or, "
        "with --device reference, all",
        "power|uniform|all");
    addParsed(command, "--texture-filter", options.textureFilter, parseTextureFilter,
              "Filter of all textures (default: as the scene says)", "scene|bilinear|nearest");
}

/// What is kept of a render beside its pictures.
void addFilmOptions(CLI::App& command, RenderOptions& options) {
    FilmOptions& film = options.film;
    command
        .add_option("--film", film.film,
                    "Keep the raw film in this file, for --resume and for calotype merge")
        ->type_name("FILE");
    command.add_option("--resume", film.resume, "Go on with this film, and keep it there")
        ->type_name("FILE");
    const auto parseInterval = [](const std::string& text) {
        return parseDuration("--checkpoint", text);
    };
    addParsed(command, "--checkpoint", film.checkpointSeconds, parseInterval,
              "How often the film is kept on the way (default: 60s)", "60s");
    addParsed(command, "--samples", options.samples, parseSamples,
              "Render these samples of each pixel only, multiples of 16", "FIRST:END")
        ->excludes("--spp");
}

} // namespace

CLI::App& addRenderCommand(CLI::App& app, RenderOptions& options) {
    CLI::App& command = *app.add_subcommand("render", "Render a scene to pictures");
    addSceneOptions(command, options.scene);
    command
        .add_option("-o,--output", options.outputs,
                    "Picture to write: .png (display), .exr or .pfm (linear); may be repeated")
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    addGoalOptions(command, options);
    addParsed(command, "--size", options.size, parseSize, "Size of the picture", "WxH");
    addParsed(command, "--crop", options.crop, parseCrop, "Render only this part", "X,Y,W,H");
    command.add_option("--seed", options.seed, "Seed of the random numbers")->type_name("N");
    addTransportOptions(command, options);
    addDisplayOptions(command, options.display);
    addLayerOption(command, options.layers, allLayers());
    addStageOptions(command, options.stages);
    addParsed(command, "--preview-every", options.previewInterval, parsePreviewInterval,
              "Write the picture so far every N samples, or every so many seconds", "N|10s");
    command
        .add_option("--preview-file", options.previewFile,
                    "Where previews go (default: the first output)")
        ->type_name("FILE");
    addFilmOptions(command, options);
    addSamplerOption(command, options.sampler);
    addBvhOption(command, options.bvh);
    command.add_option("--stats", options.statsFile, "Write statistics as JSON")->type_name("FILE");
    command.add_flag("-q,--quiet", options.quiet, "No progress, only warnings and errors")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    addDeviceOptions(command, options.device,
                     "; \"reference\": the reference tracer, in double precision on the CPU");
    return command;
}

} // namespace calotype
