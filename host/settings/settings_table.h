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

/// What a setting is for: the headings of --help.
enum class SettingGroup : uint8_t { Picture, End, Sampling, Light };
const char* nameOf(SettingGroup group);

/// The commands that take a setting, as bits.
enum SettingCommand : uint32_t {
    kRenderCommand = 1,
    kStudyCommand = 2,
    kBenchCommand = 4,
    kInfoCommand = 8,
};

/// One row of the table of settings. Command line, help, film labels, metadata, statistics, study
/// and docs are made from the rows: a new setting is a field of RenderSettings, a row, and its use.
struct Setting {
    std::string name;     ///< "max_bounces", as films and statistics have it
    std::string type;     ///< of the value, for help: "on|off"; empty for a switch without a value
    std::string help;     ///< what it does, and its default
    std::string expected; ///< what a value must be, for messages: "'7' is not ..."
    SettingGroup group = SettingGroup::Light;
    uint32_t commands = kRenderCommand; ///< SettingCommand
    /// Whether samples depend on it: then films of different values do not go together.
    bool changesSamples = false;
    /// Whether its default is the scene's, not that of RenderSettings.
    bool isOfScene = false;

    /// Sets it from a text. False where that is not `expected`.
    std::function<bool(std::string_view text, RenderSettings&)> read;
    /// As `read` takes it, with no more digits than needed.
    std::function<std::string(const RenderSettings&)> print;
    /// For statistics: a number, a switch, a list, or null where there is none.
    std::function<nlohmann::ordered_json(const RenderSettings&)> value;

    /// "--max-bounces".
    std::string option() const;
};

/// All settings, by group.
std::span<const Setting> settingsTable();

/// None where there is no such setting.
const Setting* findSetting(std::string_view name);

/// Sets one setting. Throws SettingError where the text is not what is expected.
void readSetting(const Setting& setting, std::string_view text, RenderSettings& settings);

/// What samples depend on, by the names of the settings.
using SettingTexts = std::map<std::string, std::string>;
SettingTexts sampleSettings(const RenderSettings& settings);

/// Such texts as this version would write them: settings that the writer did not know are at their
/// defaults, and texts that cannot be read stay as they are.
SettingTexts normalized(SettingTexts texts);

/// The options of `calotype render` by which `changed` differs from `usual`: "--mis off".
std::string optionsBetween(const RenderSettings& usual, const RenderSettings& changed);

/// Settings that a user gave as text, to be put over those of a scene.
class GivenSettings {
public:
    /// Throws SettingError where the text is not what is expected.
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
