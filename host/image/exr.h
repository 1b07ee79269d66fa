#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "image/exr_layers.h"
#include "image/image.h"

namespace calotype {

/// Where a cropped picture lies on its film, in pixels from the film's top left corner.
struct CropPlacement {
    uint32_t x = 0;
    uint32_t y = 0;
    uint32_t filmWidth = 0;
    uint32_t filmHeight = 0;
};

/// How a picture came about, kept in the header of its EXR file.
struct ExrMetadata {
    std::string version;          ///< calotype:version, string
    uint64_t sceneHash = 0;       ///< calotype:sceneHash, string of 16 hexadecimal digits
    uint32_t seed = 0;            ///< calotype:seed, double (EXR's int would lose the upper half)
    std::string sampler;          ///< calotype:sampler, string
    uint32_t samplesPerPixel = 0; ///< calotype:spp, int
    double seconds = 0.0;         ///< calotype:seconds, double: time of rendering
    std::optional<CropPlacement> crop; ///< none: the picture is the whole film
};

/// Writes channels R, G and B of 32-bit float, and those of `layers`, bit for bit, compressed by
/// ZIP, whole at every moment. The display window is the film, the data window the crop. Throws
/// OutputError.
void writeExr(const std::filesystem::path& path, const Image& image, const ExrMetadata& metadata,
              const ExrLayers& layers = {});

/// Reads the data window of channels R, G and B, of half or float. Throws SceneError if the file
/// cannot be read, is damaged, or lacks one of the three.
Image readExr(const std::filesystem::path& path);

} // namespace calotype
