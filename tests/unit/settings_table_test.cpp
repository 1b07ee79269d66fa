// The table of settings: rows read what they print, and films of earlier versions are understood.
#include <map>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "base/error.h"
#include "settings/limits.h"
#include "settings/settings_table.h"

namespace calotype::test {
namespace {

/// A text of each setting that is not its default.
const std::map<std::string, std::string> kOthers = {
    {"size", "640x48"},         {"crop", "1,2,30,40"},
    {"denoise", "oidn"},        {"spp", "7"},
    {"target_error", "0.05"},   {"time", "90s"},
    {"samples", "16:48"},       {"adaptive", "on"},
    {"sampler", "independent"}, {"seed", "4294967295"},
    {"bvh", "median"},          {"everything", "on"},
    {"roulette", "off"},        {"mis", "off"},
    {"max_bounces", "3"},       {"clamp_indirect", "0.3"},
    {"light_choice", "all"},    {"texture_filter", "nearest"},
    {"transparent", "on"}};

TEST(SettingsTableTest, EveryRowReadsWhatItPrints) {
    std::set<std::string> names;
    for (const Setting& setting : settingsTable()) {
        SCOPED_TRACE(setting.name);
        EXPECT_TRUE(names.insert(setting.name).second) << "a second row of this name";
        ASSERT_TRUE(kOthers.contains(setting.name));
        const std::string& text = kOthers.at(setting.name);
        RenderSettings settings;
        EXPECT_NE(setting.print(settings), text);
        const auto before = setting.value(settings);
        readSetting(setting, text, settings);
        EXPECT_EQ(setting.print(settings), text);
        EXPECT_NE(setting.value(settings), before);
        EXPECT_FALSE(setting.help.empty());
        EXPECT_EQ(findSetting(setting.name), &setting);
    }
    EXPECT_EQ(names.size(), kOthers.size());
    EXPECT_EQ(findSetting("colour"), nullptr);
}

TEST(SettingsTableTest, RefusesWhatIsNotExpected) {
    const std::map<std::string, std::vector<std::string>> wrong = {
        {"size", {"", "64", "0x4", "64x65536", "64x48x2", "-1x4"}},
        {"crop", {"0,0,4", "0,0,0,4", "0,0,4,0", "a,0,4,4"}},
        {"spp", {"0", "67108865", "1.5", "many"}},
        {"target_error", {"0", "1", "-0.1", "nan", "2 %"}},
        {"time", {"0", "-1s", "1d", "1e10"}},
        {"samples", {"0:0", "16:8", "1:16", "0:67108880"}},
        {"sampler", {"halton", "Sobol"}},
        {"seed", {"-1", "4294967296"}},
        {"max_bounces", {"-1", "1048577"}},
        {"mis", {"yes", ""}},
        {"clamp_indirect", {"0", "-1", "inf", "nan", "on"}},
        {"light_choice", {"best"}},
        {"texture_filter", {"cubic"}},
        {"bvh", {"fast"}}};
    for (const auto& [name, texts] : wrong)
        for (const std::string& text : texts) {
            RenderSettings settings;
            try {
                readSetting(*findSetting(name), text, settings);
                ADD_FAILURE() << name << " takes '" << text << "'";
            } catch (const SettingError& error) {
                EXPECT_EQ(error.setting(), name);
                EXPECT_NE(error.problem().find("'" + text + "' is not "), std::string::npos);
            }
        }
}

TEST(SettingsTableTest, RowsOfWholeNumbersCheckWhatProgramsSet) {
    const auto faultOf = [](const char* name, uint32_t samples, uint32_t bounces) {
        RenderSettings settings;
        settings.samplesPerPixel = samples;
        settings.maxBounces = bounces;
        return findSetting(name)->fault(settings);
    };
    for (const uint32_t samples : {1u, kMostSamplesPerPixel})
        EXPECT_EQ(faultOf("spp", samples, 0), "");
    EXPECT_EQ(faultOf("spp", 0, 0), "is 0, and not from 1 to 67108864");
    EXPECT_EQ(faultOf("spp", 67108865, 0), "is 67108865, and not from 1 to 67108864");
    EXPECT_EQ(faultOf("max_bounces", 1, 0), "");
    EXPECT_EQ(faultOf("max_bounces", 1, 1048577), "is 1048577, and not from 0 to 1048576");
}

// Version 1 wrote a clamp in double precision, and every setting that changes the samples.
TEST(SettingsTableTest, UnderstandsFilmsOfBefore) {
    RenderSettings settings;
    settings.width = 64;
    settings.height = 48;
    settings.crop = {0, 0, 64, 48};
    settings.transport.indirectClamp = 0.3f;
    const SettingTexts now = sampleSettings(settings);
    SettingTexts before = now;
    before["clamp_indirect"] = "0.30000001192092896";
    EXPECT_EQ(normalized(before), now);
    before.erase("mis"); // as if it had not been there yet: the default
    EXPECT_EQ(normalized(before), now);
    before.erase("transparent"); // which films from before it are not
    EXPECT_EQ(normalized(before), now);
    before.erase("size"); // which has none
    EXPECT_FALSE(normalized(before).contains("size"));
    before["seed"] = "unreadable";
    before["later"] = "unknown";
    EXPECT_EQ(normalized(before).at("seed"), "unreadable");
    EXPECT_EQ(normalized(before).at("later"), "unknown");
}

// What films of different values would mix.
TEST(SettingsTableTest, LabelsFilmsWithWhatChangesSamples) {
    std::set<std::string> names;
    for (const auto& [name, text] : sampleSettings({}))
        names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"size", "crop", "seed", "sampler", "max_bounces", "mis",
                                            "roulette", "clamp_indirect", "light_choice",
                                            "texture_filter", "bvh", "transparent"}));
}

TEST(SettingsTableTest, SaysChangesAsOptions) {
    RenderSettings changed;
    EXPECT_EQ(optionsBetween({}, changed), "");
    changed.isAdaptive = true;
    changed.transport.usesMis = false;
    changed.transport.indirectClamp = 2.5f;
    changed.compilesEverything = true; // which render does not take
    EXPECT_EQ(optionsBetween({}, changed), "--adaptive --mis off --clamp-indirect 2.5");
}

TEST(SettingsTableTest, AppliesWhatWasGiven) {
    GivenSettings given;
    given.add(*findSetting("spp"), "12");
    given.add(*findSetting("adaptive"), "on");
    EXPECT_THROW(given.add(*findSetting("seed"), "x"), SettingError);
    EXPECT_TRUE(given.has("spp"));
    EXPECT_FALSE(given.has("seed"));
    EXPECT_EQ(given.options(), "--spp 12 --adaptive");
    RenderSettings settings;
    settings.seed = 3;
    given.applyTo(settings);
    EXPECT_EQ(settings.samplesPerPixel, 12u);
    EXPECT_EQ(settings.seed, 3u);
    EXPECT_TRUE(settings.isAdaptive);
}

} // namespace
} // namespace calotype::test
