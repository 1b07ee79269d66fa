#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options.h"

namespace calotype {

// What several commands take.
void addOverrides(CLI::App& command, std::vector<SceneOverride>& overrides);
void addSceneOptions(CLI::App& command, SceneOptions& scene);
void addDeviceOptions(CLI::App& command, DeviceOptions& device, const std::string& others = "");
void addDisplayOptions(CLI::App& command, DisplayTransform& display);
/// A flag for each stage of the table.
void addStageOptions(CLI::App& command, StageList& stages);
/// Names the layers that are available.
void addLayerOption(CLI::App& command, LayerList& layers, const LayerList& available);
void addQuietFlag(CLI::App& command, bool& quiet);

/// An option for each setting of the table that the command takes.
void addSettings(CLI::App& command, SettingCommand which, GivenSettings& settings);

CLI::App& addRenderCommand(CLI::App& app, RenderOptions& options);

/// An option whose text a function of parse_values.h turns into `target`.
template <typename Target, typename Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& name, Target& target, Parse parse,
                       const std::string& description, const std::string& type) {
    return command
        .add_option_function<std::string>(
            name, [&target, parse](const std::string& text) { target = parse(text); }, description)
        ->type_name(type);
}

} // namespace calotype
