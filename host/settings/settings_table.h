#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "settings/render_settings.h"

namespace calotype {

/// The purpose of a setting: the headings of --help.
enum class SettingGroup : uint8_t { Picture, End, Sampling, Light };
const char* nameOf(SettingGroup group);

/// The commands that take a setting, as bits.
enum SettingCommand : uint32_t {
    kRenderCommand = 1,
    kStudyCommand = 2,
    kBenchCommand = 4,
    kInfoCommand = 8,
    kMergeCommand = 16,
    kDenoiseCommand = 32,
};

/// One row of the table of settings. Command line, help, film labels, metadata, statistics, study
/// and docs use the rows. To add a setting: a field of RenderSettings, a row, and its use.
struct Setting {
    std::string name = {}; ///< "max_bounces", the name in films and statistics
    std::string type = {}; ///< of the value, for help: "on|off"; empty for a switch without a value
    std::string help = {}; ///< what it does, and its default
    std::string expected = {}; ///< what a value must be, for messages: "'7' is not ..."
    SettingGroup group = SettingGroup::Light;
    uint32_t commands = kRenderCommand; ///< SettingCommand
    /// Whether samples depend on it: then films with different values cannot be joined.
    bool changesSamples = false;
    /// Whether its default comes from the scene, not from RenderSettings.
    bool isOfScene = false;

    /// Sets it from a text. False if the text is not `expected`.
    std::function<bool(std::string_view text, RenderSettings&)> read = {};
    /// The text for `read`, with no more digits than needed.
    std::function<std::string(const RenderSettings&)> print = {};
    /// For statistics: a number, a switch, a list, or null if there is none.
    std::function<nlohmann::ordered_json(const RenderSettings&)> value = {};
    /// What is wrong with a value that a program set: "is 0, and not from 1 to 9"; empty if
    /// nothing. Without this function, host/engine/scene_settings.cpp checks what must be checked.
    std::function<std::string(const RenderSettings&)> fault = {};

    /// "--max-bounces".
    std::string option() const;
};

/// All settings, by group.
std::span<const Setting> settingsTable();

/// Null if there is no such setting.
const Setting* findSetting(std::string_view name);

/// Sets one setting. Throws SettingError if the text is not what is expected.
void readSetting(const Setting& setting, std::string_view text, RenderSettings& settings);

/// The settings that samples depend on, as texts by name.
using SettingTexts = std::map<std::string, std::string>;
SettingTexts sampleSettings(const RenderSettings& settings);

/// Converts such texts to the form of this version: settings that are missing get their defaults;
/// texts that cannot be read stay unchanged.
SettingTexts normalized(SettingTexts texts);

/// The options of `calotype render` that turn `usual` into `changed`: "--mis off".
std::string optionsBetween(const RenderSettings& usual, const RenderSettings& changed);

/// Settings that a user gave as texts; they override those of a scene.
class GivenSettings {
public:
    /// Throws SettingError if the text is not what is expected.
    void add(const Setting& setting, const std::string& text);

    bool has(std::string_view name) const;

    /// As options of the command line: "--size 64x48".
    std::string options() const;

    void applyTo(RenderSettings& settings) const;

private:
    struct Given {
        const Setting* setting;
        std::string text;
    };
    std::vector<Given> given_;
};

} // namespace calotype
