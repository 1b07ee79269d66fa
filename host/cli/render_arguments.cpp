#include <string>

#include "cli/arguments.h"
#include "cli/parse_values.h"

namespace calotype {
namespace {

constexpr const char* kOutput = "Output";
constexpr const char* kFilm = "Film";

void addOutputOptions(CLI::App& command, OutputOptions& output) {
    command
        .add_option("-o,--output", output.pictures,
                    "Picture to write: .png (display), .exr or .pfm (linear); may be repeated")
        ->type_name("FILE")
        ->expected(1)
        ->take_all()
        ->group(kOutput);
    addDisplayOptions(command, output.display);
    addLayerOption(command, output.layers, allLayers());
    addParsed(command, "--preview-every", output.previewInterval, parsePreviewInterval,
              "Write the picture so far every N samples, or every so many seconds", "N|10s")
        ->group(kOutput);
    command
        .add_option("--preview-file", output.previewFile,
                    "Where previews go (default: the first output)")
        ->type_name("FILE")
        ->group(kOutput);
    addStatsOption(command, output.statsFile)->group(kOutput);
}

/// Options of the film.
void addFilmOptions(CLI::App& command, FilmOptions& film) {
    command
        .add_option("--film", film.film,
                    "Keep the raw film in this file, for calotype merge and to go on later; if it "
                    "exists, it is continued")
        ->type_name("FILE")
        ->group(kFilm);
    command
        .add_option("--resume", film.resume,
                    "Go on with this film, which must exist, and keep it there, or in --film")
        ->type_name("FILE")
        ->group(kFilm);
    command
        .add_flag("--overwrite", film.overwrites,
                  "Begin the film of --film anew, even if it exists")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw)
        ->group(kFilm);
    const auto parseInterval = [](const std::string& text) {
        return parseDuration("--checkpoint", text);
    };
    addParsed(command, "--checkpoint", film.checkpointSeconds, parseInterval,
              "How often the film is kept on the way (default: 60s)", "60s")
        ->group(kFilm);
}

} // namespace

CLI::App& addRenderCommand(CLI::App& app, RenderOptions& options) {
    CLI::App& command = *app.add_subcommand("render", "Render a scene to pictures");
    addSceneOptions(command, options.scene);
    addOutputOptions(command, options.output);
    addSettings(command, kRenderCommand, options.settings);
    command.get_option("--samples")->excludes("--spp");
    addFilmOptions(command, options.film);
    addDeviceOptions(command, options.device,
                     "; \"reference\": the reference tracer, in double precision on the CPU");
    addParsed(command, "--progress", options.progress, parseProgressStyle,
              "Progress on standard error: text (default), or json, a line for each update "
              "(docs/json.md)",
              "text|json");
    addQuietFlag(command, options.quiet);
    command.footer("Example: a picture of 256 samples per pixel, in linear light and for display:\n"
                   "  calotype render scenes/cornell-box.json --spp 256 -o box.exr -o box.png");
    return command;
}

} // namespace calotype
