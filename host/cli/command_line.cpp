#include "cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "base/output_lock.h"
#include "cli/arguments.h"
#include "cli/command_errors.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/markdown_help.h"
#include "cli/parse_values.h"
#include "engine/bench.h"
#include "engine/version.h"

namespace calotype {
namespace {

int fail(const std::string& message, ExitCode code) {
    std::fprintf(stderr, "calotype: %s\n", message.c_str());
    return code;
}

/// The error with the name of the option: "--crop reaches beyond the picture".
std::string optionOf(const SettingError& error) {
    const Setting* setting = findSetting(error.setting());
    return (setting ? setting->option() : error.setting()) + " " + error.problem();
}

/// Runs `action` and converts errors to exit codes.
int withExitCode(const std::function<int()>& action) {
    try {
        return action();
    } catch (const SettingError& error) {
        return fail(optionOf(error), kExitUsage);
    } catch (const UsageError& error) {
        return fail(error.what(), kExitUsage);
    } catch (const SceneError& error) {
        return fail(error.what(), kExitScene);
    } catch (const GpuError& error) {
        return fail(error.what(), kExitDevice);
    } catch (const OutputBusyError& error) {
        return fail(error.what(), kExitBusy);
    } catch (const OutputError& error) {
        return fail(error.what(), kExitOutput);
    } catch (const Error& error) {
        return fail(error.what(), kExitOther);
    } catch (const std::bad_alloc&) {
        return fail("this machine has not enough memory", kExitOther);
    } catch (const std::exception& error) {
        return fail(std::string("unexpected: ") + error.what(), kExitOther);
    }
}

CLI::App& addCompareCommand(CLI::App& app, CompareOptions& options) {
    CLI::App& command = *app.add_subcommand("compare", "Say how far picture A is from picture B");
    command.add_option("A", options.a, "Picture to judge: EXR, PFM, HDR or PNG")
        ->required()
        ->type_name("FILE");
    command.add_option("B", options.b, "Picture to compare it with, of the same size")
        ->required()
        ->type_name("FILE");
    command.add_option("--diff", options.differenceFile, "Write the differences in false colour")
        ->type_name("OUT.png");
    addParsed(command, "--max-relmse", options.maxRelativeMse, parseMaxRelativeMse,
              "Exit with 5 if the relative MSE is larger, or a pixel infinite in A or B only", "X");
    command.add_flag("--json", options.asJson, "Print JSON (docs/json.md)");
    command.footer(
        "Pictures are compared as linear light: PNGs are decoded from sRGB. Alpha is left out.\n"
        "Relative MSE: the mean over pixels and channels of (A - B)^2 / (B^2 + 0.01).\n"
        "Colours of --diff, for the root of each pixel's relative MSE, in equal steps of its "
        "logarithm:\nblack below 1e-4, dark blue 1e-4, violet 1e-3, crimson 1e-2, orange 0.1, "
        "yellow "
        "1 and more;\ncyan where A or B is infinite. Such pixels are counted and left out of all "
        "else.\n\n"
        "Example: calotype compare picture.exr converged.exr --diff errors.png");
    return command;
}

CLI::App& addMergeCommand(CLI::App& app, MergeOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "merge", "Join films of one scene, or make pictures of one or more of them");
    command.add_option("films", options.films, "Films, none of which share samples")
        ->required()
        ->type_name("FILM");
    command
        .add_option("-o,--output", options.outputs,
                    "Film to write, or picture (.png, .exr or .pfm); may be repeated")
        ->required()
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    addParsed(command, "--require", options.required, parseSampleRange,
              "Exit with 5, and write nothing, if the films lack any of these samples",
              "FIRST:END");
    command
        .add_flag("--overwrite", options.overwrites,
                  "Replace an existing film even if it holds samples that these films lack")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    addLayerOption(command, options.layers, layersOfFilms());
    addDisplayOptions(command, options.display);
    addSettings(command, kMergeCommand, options.settings);
    command.get_option("--denoise")
        ->description("Remove the noise of the pictures, and state their error: off (default), "
                      "oidn (Open Image Denoise 2), or statistical, on the CPU");
    addThreadsOption(command, options.threads);
    command.add_flag("--json", options.asJson, "Print what the films hold as JSON (docs/json.md)");
    command.footer("Prints which samples the films hold, and which are missing in between.\n\n"
                   "Example: calotype merge first.film second.film -o both.film -o both.exr");
    return command;
}

CLI::App& addDenoiseCommand(CLI::App& app, DenoiseOptions& options) {
    CLI::App& command =
        *app.add_subcommand("denoise", "Denoise a film, and state the error, or an EXR picture");
    command
        .add_option("input", options.input,
                    "Film that was rendered with --denoise, or .exr picture, best with the layers "
                    "meanAlbedo and meanNormal")
        ->required()
        ->type_name("INPUT");
    command
        .add_option("-o,--output", options.outputs,
                    "Picture to write: .png (display), .exr or .pfm (linear); may be repeated")
        ->required()
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    addDisplayOptions(command, options.display);
    addStatsOption(command, options.statsFile)->group("Output");
    addSettings(command, kDenoiseCommand, options.settings);
    command.get_option("--denoise")
        ->description("Denoiser: oidn (Open Image Denoise 2, the default), or statistical, on the "
                      "CPU, of a film")
        ->type_name("oidn|statistical");
    addThreadsOption(command, options.threads);
    addQuietFlag(command, options.quiet);
    command.footer(
        "An .exr output keeps the picture as it was as the layer \"noisy\", and the other "
        "layers of an\n.exr input. No error is stated of an .exr input.\n\n"
        "Example: calotype denoise atelier.film -o atelier.exr -o atelier.png");
    return command;
}

CLI::App& addInfoCommand(CLI::App& app, InfoOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "info", "Print what a scene holds and what it takes on the device, or what a film holds");
    addSceneOptions(command, options.scene);
    command.add_flag("--json", options.asJson, "Print JSON (docs/json.md)");
    addSettings(command, kInfoCommand, options.settings);
    addDeviceOptions(command, options.device);
    command.footer("Example: calotype info scenes/cornell-box.json");
    return command;
}

CLI::App& addStudyCommand(CLI::App& app, StudyOptions& options) {
    CLI::App& command = *app.add_subcommand(
        "study",
        "Measure time and error of each render setting for a scene, and recommend settings");
    addSceneOptions(command, options.scene);
    const auto parseBudget = [](const std::string& text) {
        return parseDuration("--budget", text);
    };
    addParsed(command, "--budget", options.budget, parseBudget,
              "Time for all of it: 90s, 5m (the default), 1h", "5m");
    command
        .add_option(
            "-o,--output", options.folder,
            "Folder for study.csv, study.json, study.svg and study.html (default: study-SCENE)")
        ->type_name("DIR");
    addSettings(command, kStudyCommand, options.settings);
    addQuietFlag(command, options.quiet);
    addDeviceOptions(command, options.device,
                     "; \"reference\": the reference tracer, in double precision on the CPU");
    command.footer(
        "Two fifths of the time go to the ground truth, a picture of many samples. The rest is "
        "shared\nequally by the default settings, by settings with one change each, by a basic "
        "path tracer (no\nMIS, no roulette, independent samples, 4 bounces), and last by all "
        "improvements together. Without\n--size the pictures are smaller than the scene's where "
        "time is short. Ctrl-C keeps what was\nmeasured so far.\n\n"
        "Example: calotype study scenes/cornell-box.json --budget 10m -o study");
    return command;
}

CLI::App& addBenchCommand(CLI::App& app, BenchOptions& options) {
    CLI::App& command = *app.add_subcommand("bench", "Measure how fast scenes are rendered");
    command
        .add_option("scenes", options.scenes,
                    "Scene files (default: two generated scenes of 786,000 triangles)")
        ->type_name("SCENE");
    addOverrides(command, options.overrides);
    command.add_option("--repeats", options.repeats, "Repeats of each measurement")
        ->check(CLI::Range(1u, 1000u))
        ->capture_default_str()
        ->type_name("N");
    command.add_option("--json", options.jsonFile, "Write a line of JSON a scene")
        ->type_name("FILE");
    addSettings(command, kBenchCommand, options.settings);
    command.get_option("--spp")->description(
        "Samples per pixel of a repeat (default: " + std::to_string(kBenchSamples) + ")");
    addDeviceOptions(command, options.device);
    command.footer(
        "Rates are medians of the repeats, after one that is not counted, with the "
        "least and the greatest.\nRays of the traversal alone are those of the picture's "
        "paths: from the camera, after three bounces,\nand from what the camera sees to "
        "the lights.\n\n"
        "Example: calotype bench scenes/cornell-box.json --json bench.jsonl");
    return command;
}

/// The exit code, if all of standard output was written. Throws OutputError if not.
int flushed(int code) {
    if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0)
        throw OutputError("cannot write to standard output");
    return code;
}

/// The words of the command line; "help render" as "render --help". Throws UsageError if there is
/// no such command.
std::vector<std::string> wordsOf(int argc, char** argv, const CLI::App& app) {
    std::vector<std::string> words(argv + 1, argv + argc);
    const bool hasOption = words.size() > 1 && words[1].starts_with('-'); // help --help
    if (words.empty() || words.front() != "help" || hasOption)
        return words;
    words.erase(words.begin());
    const auto isNamed = [&](const CLI::App* command) {
        return command->get_name() == words.front();
    };
    if (!words.empty() && app.get_subcommands(isNamed).empty())
        throw UsageError(unknownCommandSentence(app, words.front()));
    words.push_back("--help");
    return words;
}

int parseAndRun(int argc, char** argv) {
    CLI::App app("Calotype: a headless path tracer on Vulkan compute.\n"
                 "Exit codes: 0 done, 1 interrupted or anything else, 2 wrong usage,\n3 bad scene "
                 "or input file, 4 device or driver, 5 pictures differ by more than\n--max-relmse "
                 "or films lack samples of --require, 6 an output that cannot be written,\n7 "
                 "another process writes an output.",
                 "calotype");
    app.set_version_flag("--version", std::string("calotype ") + versionText());
    bool wantsMarkdown = false;
    app.add_flag("--help-markdown", wantsMarkdown, "Print the help of all commands as Markdown");
    app.require_subcommand(0, 1); // no command is reported below, after unknown words
    RenderOptions renderOptions;
    InfoOptions infoOptions;
    MergeOptions mergeOptions;
    DenoiseOptions denoiseOptions;
    CompareOptions compareOptions;
    StudyOptions studyOptions;
    BenchOptions benchOptions;
    DevicesOptions devicesOptions;
    CLI::App& render = addRenderCommand(app, renderOptions);
    CLI::App& info = addInfoCommand(app, infoOptions);
    CLI::App& merge = addMergeCommand(app, mergeOptions);
    CLI::App& denoise = addDenoiseCommand(app, denoiseOptions);
    CLI::App& compare = addCompareCommand(app, compareOptions);
    CLI::App& study = addStudyCommand(app, studyOptions);
    CLI::App& bench = addBenchCommand(app, benchOptions);
    CLI::App& devices = *app.add_subcommand("devices", "List devices and say which one is taken");
    addDeviceOptions(devices, devicesOptions.device);
    devices.add_flag("--json", devicesOptions.asJson, "Print JSON (docs/json.md)");
    devices.footer("Example: calotype devices --device 1");
    CLI::App& schema =
        *app.add_subcommand("schema", "Print the JSON Schema of scene files, for editors");
    schema.footer("Example: calotype schema > scene.schema.json");
    CLI::App& help = *app.add_subcommand("help", "Print the help of a command, or of all");
    std::string unused; // wordsOf has replaced this command
    help.add_option("command", unused, "The command")->type_name("COMMAND");
    help.footer("Example: calotype help render");
    // Commands that are added later would have it, too.
    app.footer("Example: calotype render scenes/cornell-box.json -o box.png");
    try {
        std::vector<std::string> words = wordsOf(argc, argv, app);
        std::ranges::reverse(words); // as CLI11 takes them
        app.parse(std::move(words));
    } catch (const CLI::Success& success) { // --help, --version
        app.exit(success);
        return flushed(kExitDone);
    } catch (const CLI::ParseError& error) {
        throw UsageError(sentenceOf(app, error));
    }
    if (wantsMarkdown) {
        std::fputs(markdownHelp(app).c_str(), stdout);
        return flushed(kExitDone);
    }
    if (app.get_subcommands().empty())
        throw UsageError(noCommandSentence());
    if (render.parsed())
        return renderCommand(renderOptions);
    const int code = info.parsed()      ? infoCommand(infoOptions)
                     : merge.parsed()   ? mergeCommand(mergeOptions)
                     : denoise.parsed() ? denoiseCommand(denoiseOptions)
                     : compare.parsed() ? compareCommand(compareOptions)
                     : study.parsed()   ? studyCommand(studyOptions)
                     : bench.parsed()   ? benchCommand(benchOptions)
                     : schema.parsed()  ? schemaCommand()
                                        : devicesCommand(devicesOptions);
    return flushed(code);
}

} // namespace

int runCommandLine(int argc, char** argv) {
    return withExitCode([&] { return parseAndRun(argc, argv); });
}

} // namespace calotype
