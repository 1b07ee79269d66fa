#include "cli/exr_metadata.h"

#include <algorithm>
#include <limits>

#include "base/hexadecimal.h"
#include "cli/parse_values.h"

namespace calotype {

void describe(Picture& picture, const FilmLabel& label, uint64_t samplesPerPixel, double seconds) {
    const PictureSize size = parseSize(label.setting("size"));
    const Crop crop = parseCrop(label.setting("crop"));
    picture.crop = CropPlacement{crop.x, crop.y, size.width, size.height};
    picture.metadata = {
        {"version", label.setting("version")},
        {"sceneHash", hexadecimal(label.sceneHash)},
        {"seed",
         static_cast<double>(std::stoul(label.setting("seed")))}, // too large for an int32_t
        {"sampler", label.setting("sampler")},
        {"spp", static_cast<int32_t>(
                    std::min<uint64_t>(samplesPerPixel, std::numeric_limits<int32_t>::max()))},
        {"seconds", seconds},
    };
}

} // namespace calotype
