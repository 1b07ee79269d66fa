#include "cli/arguments.h"

#include "cli/parse_values.h"

namespace calotype {

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
        ->take_all()
        ->group("Scene");
}

/// Options that place the camera, of a scene or of a bare model.
void addViewOptions(CLI::App& command, ViewOptions& view) {
    const auto add = [&](const std::string& name, std::optional<glm::dvec3>& point,
                         const std::string& description) {
        addParsed(
            command, name, point,
            [name](const std::string& text) { return parsePoint(name, text); }, description,
            "X,Y,Z")
            ->group("Scene");
    };
    add("--from", view.from, "Position of the camera, metres (default: the scene's)");
    add("--look-at", view.lookAt, "Point that the camera looks at, metres (default: the scene's)");
    addParsed(command, "--up", view.up, parseUp,
              "Direction that is up in the picture (default: the scene's)", "X,Y,Z")
        ->group("Scene");
    addParsed(command, "--fov", view.fov, parseFieldOfView,
              "Vertical field of view (default: the scene's)", "DEGREES")
        ->group("Scene");
}

void addSceneOptions(CLI::App& command, SceneOptions& scene) {
    command.add_option("scene", scene.path, "Scene file (JSON), or a model (OBJ) to show")
        ->required()
        ->type_name("SCENE");
    addOverrides(command, scene.overrides);
    addParsed(command, "--missing-textures", scene.missingTextures, parseMissingTextures,
              "Where an image file is missing or cannot be read: fail, or warn and show magenta",
              "fail|warn")
        ->group("Scene");
    addViewOptions(command, scene.view);
}

void addDeviceOptions(CLI::App& command, DeviceOptions& device, const std::string& others) {
    command
        .add_option("--device", device.device,
                    "Device by its index, a part of its name or driver, its UUID or PCI address "
                    "(else CALOTYPE_DEVICE, else the best)" +
                        others)
        ->type_name("DEVICE")
        ->group("Device");
    addThreadsOption(command, device.threads);
}

void addThreadsOption(CLI::App& command, uint32_t& threads) {
    command.add_option("--threads", threads, "Threads on the CPU (default: all cores)")
        ->check(CLI::Range(1, 1024))
        ->type_name("N")
        ->group("Device");
}

void addSettings(CLI::App& command, SettingCommand which, GivenSettings& settings) {
    for (const Setting& setting : settingsTable()) {
        if (!(setting.commands & which))
            continue;
        CLI::Option* option = nullptr;
        if (setting.type.empty())
            option = command
                         .add_flag_function(
                             setting.option(), [&](int64_t) { settings.add(setting, "on"); },
                             setting.help)
                         ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
        else
            option =
                command
                    .add_option_function<std::string>(
                        setting.option(),
                        [&](const std::string& text) { settings.add(setting, text); }, setting.help)
                    ->type_name(setting.type);
        option->group(nameOf(setting.group));
    }
}

void addQuietFlag(CLI::App& command, bool& quiet) {
    command.add_flag("-q,--quiet", quiet, "No progress, only warnings and errors")
        ->multi_option_policy(CLI::MultiOptionPolicy::Throw);
}

CLI::Option* addStatsOption(CLI::App& command, std::string& file) {
    return command.add_option("--stats", file, "Write statistics as JSON (docs/json.md)")
        ->type_name("FILE");
}

void addDisplayOptions(CLI::App& command, DisplayTransform& display) {
    addParsed(
        command, "--exposure", display.exposureStops, parseExposure,
        "Brighten PNGs by this many stops (factors of two); auto: so that the picture's key is "
        "middle grey",
        "STOPS")
        ->group("Output");
    addParsed(command, "--tonemap", display.toneMap, parseToneMap,
              "How PNGs treat bright light: " + std::string(kToneMapNames), "NAME")
        ->group("Output");
}

void addLayerOption(CLI::App& command, LayerList& layers, const LayerList& available) {
    std::string description = "Layers of .exr outputs, separated by commas:";
    for (const Layer* layer : available)
        description += "\n" + layer->name + ": " + layer->help;
    addParsed(command, "--aov", layers, parseLayers, description, "LIST")->group("Output");
}

} // namespace calotype
