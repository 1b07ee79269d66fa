#include "cli/exr_metadata.h"

#include <algorithm>
#include <limits>

#include "cli/parse_values.h"

namespace calotype {

ExrMetadata exrMetadata(const FilmLabel& label, uint64_t samplesPerPixel, double seconds) {
    const PictureSize size = parseSize(label.setting("size"));
    const Crop crop = parseCrop(label.setting("crop"));
    ExrMetadata metadata;
    metadata.version = label.setting("version");
    metadata.sceneHash = label.sceneHash;
    metadata.seed = static_cast<uint32_t>(std::stoul(label.setting("seed")));
    metadata.sampler = label.setting("sampler");
    metadata.samplesPerPixel = static_cast<uint32_t>(
        std::min<uint64_t>(samplesPerPixel, std::numeric_limits<uint32_t>::max()));
    metadata.seconds = seconds;
    metadata.crop = CropPlacement{crop.x, crop.y, size.width, size.height};
    return metadata;
}

} // namespace calotype
