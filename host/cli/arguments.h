#pragma once

#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/options.h"

namespace calotype {

// Options that several commands have.
void addOverrides(CLI::App& command, std::vector<SceneOverride>& overrides);
void addSceneOptions(CLI::App& command, SceneOptions& scene);
void addDeviceOptions(CLI::App& command, DeviceOptions& device, const std::string& others = "");
void addThreadsOption(CLI::App& command, uint32_t& threads);
CLI::Option* addStatsOption(CLI::App& command, std::string& file);
void addDisplayOptions(CLI::App& command, DisplayTransform& display);
/// The help of the option lists the available layers.
void addLayerOption(CLI::App& command, LayerList& layers, const LayerList& available);
void addQuietFlag(CLI::App& command, bool& quiet);

/// Adds an option for each setting of the table that the command has.
void addSettings(CLI::App& command, SettingCommand which, GivenSettings& settings);

CLI::App& addRenderCommand(CLI::App& app, RenderOptions& options);

/// Adds an option; `parse`, a function of parse_values.h, converts its text to `target`.
template <typename Target, typename Parse>
CLI::Option* addParsed(CLI::App& command, const std::string& name, Target& target, Parse parse,
                       const std::string& description, const std::string& type) {
    return command
        .add_option_function<std::string>(
            name, [&target, parse](const std::string& text) { target = parse(text); }, description)
        ->type_name(type);
}

} // namespace calotype
