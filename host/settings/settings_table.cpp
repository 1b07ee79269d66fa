#include "settings/settings_table.h"

#include <algorithm>

#include <nlohmann/json.hpp>

#include "base/error.h"
#include "settings/setting_rows.h"

namespace calotype {

const char* nameOf(SettingGroup group) {
    switch (group) {
    case SettingGroup::Picture:
        return "Picture";
    case SettingGroup::End:
        return "When to stop";
    case SettingGroup::Light:
        return "Light";
    case SettingGroup::Sampling:
        break;
    }
    return "Sampling";
}

std::string Setting::option() const {
    std::string text = "--" + name;
    std::ranges::replace(text, '_', '-');
    return text;
}

std::span<const Setting> settingsTable() {
    static const std::vector<Setting> table = makeSettingRows();
    return table;
}

const Setting* findSetting(std::string_view name) {
    const auto found = std::ranges::find(settingsTable(), name, &Setting::name);
    return found == settingsTable().end() ? nullptr : &*found;
}

void readSetting(const Setting& setting, std::string_view text, RenderSettings& settings) {
    if (!setting.read(text, settings))
        throw SettingError(setting.name, "'" + std::string(text) + "' is not " + setting.expected);
}

SettingTexts sampleSettings(const RenderSettings& settings) {
    SettingTexts texts;
    for (const Setting& setting : settingsTable())
        if (setting.changesSamples)
            texts[setting.name] = setting.print(settings);
    return texts;
}

SettingTexts normalized(SettingTexts texts) {
    for (const Setting& setting : settingsTable()) {
        if (!setting.changesSamples)
            continue;
        RenderSettings settings;
        const auto found = texts.find(setting.name);
        if (found == texts.end() && !setting.isOfScene)
            texts[setting.name] = setting.print(settings);
        else if (found != texts.end() && setting.read(found->second, settings))
            found->second = setting.print(settings);
    }
    return texts;
}

std::string optionsBetween(const RenderSettings& usual, const RenderSettings& changed) {
    std::string options;
    for (const Setting& setting : settingsTable()) {
        const std::string text = setting.print(changed);
        if (!(setting.commands & kRenderCommand) || text == setting.print(usual))
            continue;
        options += (options.empty() ? "" : " ") + setting.option();
        if (!setting.type.empty())
            options += " " + text;
    }
    return options;
}

void GivenSettings::add(const Setting& setting, const std::string& text) {
    RenderSettings scratch;
    readSetting(setting, text, scratch);
    given_.push_back({&setting, text});
}

bool GivenSettings::has(std::string_view name) const {
    return std::ranges::any_of(given_,
                               [&](const Given& given) { return given.setting->name == name; });
}

std::string GivenSettings::options() const {
    std::string options;
    for (const Given& given : given_)
        options += (options.empty() ? "" : " ") + given.setting->option() +
                   (given.setting->type.empty() ? "" : " " + given.text);
    return options;
}

void GivenSettings::applyTo(RenderSettings& settings) const {
    for (const Given& given : given_)
        readSetting(*given.setting, given.text, settings);
}

} // namespace calotype
