#include "cli/command_line.h"

#include <cstdio>
#include <exception>
#include <functional>
#include <new>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "base/error.h"
#include "cli/commands.h"
#include "cli/exit_code.h"
#include "cli/parse_values.h"

namespace calotype {
namespace {

int fail(const std::string& message, ExitCode code) {
    std::fprintf(stderr, "calotype: %s\n", message.c_str());
    return code;
}

/// Runs `action`; every error ends here.
int withExitCode(const std::function<int()>& action) {
    try {
        return action();
    } catch (const UsageError& error) {
        return fail(error.what(), kExitUsage);
    } catch (const SceneError& error) {
        return fail(error.what(), kExitScene);
    } catch (const GpuError& error) {
        return fail(error.what(), kExitDevice);
    } catch (const Error& error) {
        return fail(error.what(), kExitOther);
    } catch (const std::bad_alloc&) {
        return fail("this machine has not enough memory", kExitOther);
    } catch (const std::exception& error) {
        return fail(std::string("unexpected: ") + error.what(), kExitOther);
    }
}

/// An option whose text a function of parse_values.h turns into `target`.
template <typename Target, typename Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& name, Target& target, Parse parse,
                       const std::string& description, const std::string& type) {
    return command
        .add_option_function<std::string>(
            name, [&target, parse](const std::string& text) { target = parse(text); }, description)
        ->type_name(type);
}

void addOverrides(CLI::App& command, std::vector<SceneOverride>& overrides) {
    command
        .add_option_function<std::vector<std::string>>(
            "--set",
            [&overrides](const std::vector<std::string>& texts) {
                for (const std::string& text : texts)
                    overrides.push_back(parseOverride(text));
            },
            "Change a value of the scene, e.g. /render/max_bounces=8; may be repeated")
        ->type_name("/POINTER=VALUE")
        ->expected(1)
        ->take_all();
}

void addSceneOptions(CLI::App& command, SceneOptions& scene) {
    command.add_option("scene", scene.path, "Scene file (JSON), or a model (OBJ) to show")
        ->required()
        ->type_name("SCENE");
    addOverrides(command, scene.overrides);
    addParsed(command, "--missing-textures", scene.missingTextures, parseMissingTextures,
              "Where an image file is missing: fail, or warn and show magenta", "fail|warn");
}

void addDeviceOptions(CLI::App& command, DeviceOptions& device, const std::string& others = "") {
    command
        .add_option("--device", device.device,
                    "Device by index or part of its name (else CALOTYPE_DEVICE, else the best)" +
                        others)
        ->type_name("INDEX|NAME");
    command.add_option("--threads", device.threads, "Threads on the CPU (default: all cores)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
}

void addBvhOption(CLI::App& command, std::optional<BvhBuilder>& bvh) {
    addParsed(
        command, "--bvh", bvh, parseBvh,
        "How the BVH is built: median (soon done), sah (soon traversed), or auto, the quickest "
        "for the samples asked for (default)",
        "auto|median|sah");
}

void addSamplerOption(CLI::App& command, Sampler& sampler) {
    addParsed(command, "--sampler", sampler, parseSampler,
              "How random numbers are drawn: each for itself (independent, the default), or in "
              "pairs that fill the square evenly (sobol)",
              "independent|sobol");
}

CLI::App& addRenderCommand(CLI::App& app, RenderOptions& options) {
    CLI::App& command = *app.add_subcommand("render", "Render a scene to pictures");
    addSceneOptions(command, options.scene);
    command
        .add_option("-o,--output", options.outputs,
                    "Picture to write: .png (display), .exr or .pfm (linear); may be repeated")
        ->required()
        ->type_name("FILE")
        ->expected(1)
        ->take_all();
    command.add_option("--spp", options.samplesPerPixel, "Samples per pixel")
        ->check(CLI::Range(1u, RenderDefaults::kMostSamplesPerPixel))
        ->type_name("N");
    addParsed(command, "--size", options.size, parseSize, "Size of the picture", "WxH");
    addParsed(command, "--crop", options.crop, parseCrop, "Render only this part", "X,Y,W,H");
    command.add_option("--seed", options.seed, "Seed of the random numbers")->type_name("N");
    command
        .add_option("--max-bounces", options.maxBounces,
                    "Scattering events along a path, at most; 0 shows emitters only")
        ->check(CLI::Range(0u, RenderDefaults::kMostBounces))
        ->type_name("N");
    addParsed(command, "--exposure", options.display.exposureStops, parseExposure,
              "Brighten PNGs by this many stops (factors of two)", "STOPS");
    addParsed(command, "--tonemap", options.display.toneMap, parseToneMap,
              "How PNGs treat bright light: " + std::string(kToneMapNames), "NAME");
    addParsed(
        command, "--aov", options.layers, parseLayers,
        "Layers of the first hits, for .exr outputs: albedo,normal,depth,position,primitive,uv",
        "LIST");
    addParsed(command, "--preview-every", options.previewInterval, parsePreviewInterval,
              "Write the picture so far every N samples, or every so many seconds", "N|10s");
    command
        .add_option("--preview-file", options.previewFile,
                    "Where previews go (default: the first output)")
        ->type_name("FILE");
    addSamplerOption(command, options.sampler);
    addBvhOption(command, options.bvh);
    command.add_option("--stats", options.statsFile, "Write statistics as JSON")->type_name("FILE");
    command.add_flag("-q,--quiet", options.quiet, "No progress, only warnings and errors")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
    addDeviceOptions(command, options.device,
                     "; \"reference\": the reference tracer, in double precision on the CPU");
    return command;
}

CLI::App& addCompareCommand(CLI::App& app, CompareOptions& options) {
    CLI::App& command =
        *app.add_subcommand("compare", "Say how far picture A is from picture B, the reference");
    command.add_option("A", options.a, "Picture to judge: EXR, PFM, HDR or PNG")
        ->required()
        ->type_name("FILE");
    command.add_option("B", options.b, "Reference, of the same size")
        ->required()
        ->type_name("FILE");
    command.add_option("--diff", options.differenceFile, "Write the differences in false colour")
        ->type_name("OUT.png");
    addParsed(command, "--max-relmse", options.maxRelativeMse, parseMaxRelativeMse,
              "Exit with 5 if the relative MSE is larger, or a pixel infinite in A or B only", "X");
    command.footer(
        "Pictures are compared as linear light: PNGs are decoded from sRGB. Alpha is left out.\n"
        "Relative MSE: the mean over pixels and channels of (A - B)^2 / (B^2 + 0.01).\n"
        "Colours of --diff, for the root of each pixel's relative MSE, in equal steps of its "
        "logarithm:\nblack below 1e-4, dark blue 1e-4, violet 1e-3, crimson 1e-2, orange 0.1, "
        "yellow "
        "1 and more;\ncyan where A or B is infinite. Such pixels are counted and left out of all "
        "else.");
    return command;
}

CLI::App& addBenchCommand(CLI::App& app, BenchOptions& options) {
    CLI::App& command = *app.add_subcommand("bench", "Measure how fast scenes are rendered");
    command
        .add_option("scenes", options.scenes,
                    "Scene files (default: two generated scenes of 786,000 triangles)")
        ->type_name("SCENE");
    addOverrides(command, options.overrides);
    command.add_option("--spp", options.samplesPerPixel, "Samples per pixel of a repeat")
        ->check(CLI::Range(1u, RenderDefaults::kMostSamplesPerPixel))
        ->capture_default_str()
        ->type_name("N");
    command.add_option("--repeats", options.repeats, "Repeats of each measurement")
        ->check(CLI::Range(1u, 1000u))
        ->capture_default_str()
        ->type_name("N");
    command.add_flag("--everything", options.compilesEverything,
                     "Compile the whole kernel, whatever part of it the scene needs");
    command.add_option("--json", options.jsonFile, "Write a line of JSON a scene")
        ->type_name("FILE");
    addSamplerOption(command, options.sampler);
    addBvhOption(command, options.bvh);
    addDeviceOptions(command, options.device);
    command.footer(
        "Rates are medians of the repeats, after one that is not counted, with the "
        "least and the greatest.\nRays of the traversal alone are those of the picture's "
        "paths: from the camera, after three bounces,\nand from what the camera sees to "
        "the lights.");
    return command;
}

int parseAndRun(int argc, char** argv) {
    CLI::App app("Calotype: a headless path tracer on Vulkan compute.\n"
                 "Exit codes: 0 done, 1 interrupted or an output that cannot be written, 2 wrong "
                 "usage,\n3 bad scene or input file, 4 device or driver, 5 pictures differ by more "
                 "than --max-relmse.",
                 "calotype");
    app.set_version_flag("--version", CALOTYPE_VERSION);
    app.require_subcommand(0, 1); // none is reported below, after any unknown word
    RenderOptions renderOptions;
    InfoOptions infoOptions;
    CompareOptions compareOptions;
    BenchOptions benchOptions;
    DeviceOptions devicesOptions;
    CLI::App& render = addRenderCommand(app, renderOptions);
    CLI::App& info =
        *app.add_subcommand("info", "Print what a scene holds and what it takes on the device");
    addSceneOptions(info, infoOptions.scene);
    addBvhOption(info, infoOptions.bvh);
    addDeviceOptions(info, infoOptions.device);
    CLI::App& compare = addCompareCommand(app, compareOptions);
    CLI::App& bench = addBenchCommand(app, benchOptions);
    CLI::App& devices = *app.add_subcommand("devices", "List devices and say which one is taken");
    addDeviceOptions(devices, devicesOptions);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& success) { // --help, --version
        return app.exit(success);
    } catch (const CLI::ParseError& error) {
        throw UsageError(std::string(error.what()) + " (see calotype --help)");
    }
    if (app.get_subcommands().empty())
        throw UsageError(
            "a command is required: render, info, compare, bench or devices (see calotype --help)");
    if (render.parsed())
        return renderCommand(renderOptions);
    const int code = info.parsed()      ? infoCommand(infoOptions)
                     : compare.parsed() ? compareCommand(compareOptions)
                     : bench.parsed()   ? benchCommand(benchOptions)
                                        : devicesCommand(devicesOptions);
    if (std::fflush(stdout) != 0)
        throw OutputError("cannot write to standard output");
    return code;
}

} // namespace

int runCommandLine(int argc, char** argv) {
    return withExitCode([&] { return parseAndRun(argc, argv); });
}

} // namespace calotype
