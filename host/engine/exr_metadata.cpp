#include "engine/exr_metadata.h"

#include <algorithm>
#include <limits>

#include "base/hexadecimal.h"
#include "settings/settings_table.h"

namespace calotype {

void describe(Picture& picture, const FilmLabel& label, uint64_t samplesPerPixel, double seconds) {
    RenderSettings settings;
    const auto isKnown = [&](const char* name) {
        const auto text = label.settings.find(name);
        return text != label.settings.end() && findSetting(name)->read(text->second, settings);
    };
    if (isKnown("size") && isKnown("crop"))
        picture.crop =
            CropPlacement{settings.crop.x, settings.crop.y, settings.width, settings.height};
    picture.metadata.push_back({"version", label.setting("version")});
    picture.metadata.push_back({"sceneHash", hexadecimal(label.sceneHash)});
    if (isKnown("seed")) // a double, because an int32_t may be too small
        picture.metadata.push_back({"seed", static_cast<double>(settings.seed)});
    picture.metadata.push_back({"sampler", label.setting("sampler")});
    picture.metadata.push_back({"spp", static_cast<int32_t>(std::min<uint64_t>(
                                           samplesPerPixel, std::numeric_limits<int32_t>::max()))});
    picture.metadata.push_back({"seconds", seconds});
}

} // namespace calotype
