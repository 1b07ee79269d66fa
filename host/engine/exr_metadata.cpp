#include "engine/exr_metadata.h"

#include <algorithm>
#include <limits>

#include <nlohmann/json.hpp>

#include "base/hexadecimal.h"
#include "settings/settings_table.h"

namespace calotype {
namespace {

/// A whole number as a double, which holds every seed; anything else as its text.
Attribute attributeOf(const Setting& setting, const std::string& text,
                      const RenderSettings& settings) {
    const nlohmann::ordered_json value = setting.value(settings);
    if (value.is_number_integer())
        return {setting.name, value.get<double>()};
    return {setting.name, text};
}

} // namespace

void describe(Picture& picture, const FilmLabel& label, uint64_t samplesPerPixel) {
    picture.metadata.push_back({"version", label.setting("version")});
    picture.metadata.push_back({"sceneHash", hexadecimal(label.sceneHash)});
    if (!label.camera.empty())
        picture.metadata.push_back({"camera", label.camera});
    RenderSettings settings;
    for (const Setting& setting : settingsTable()) {
        const auto text = label.settings.find(setting.name);
        if (text != label.settings.end() && setting.read(text->second, settings))
            picture.metadata.push_back(attributeOf(setting, text->second, settings));
    }
    picture.metadata.push_back({"spp", static_cast<int32_t>(std::min<uint64_t>(
                                           samplesPerPixel, std::numeric_limits<int32_t>::max()))});
    // Both are zero where the label does not say them.
    if (settings.width > 0 && settings.crop.width > 0)
        picture.crop =
            CropPlacement{settings.crop.x, settings.crop.y, settings.width, settings.height};
}

} // namespace calotype
