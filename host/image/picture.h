#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "image/image.h"

namespace calotype {

/// One number for each pixel of a picture, row by row from the top left one.
struct Channel {
    std::string name; ///< as in an EXR file: "albedo.R" is channel R of the layer "albedo"
    std::variant<std::vector<float>, std::vector<uint32_t>> pixels;
};

/// Before the names of attributes in files.
inline constexpr std::string_view kMetadataPrefix = "calotype:";

/// Attributes whose names begin like this have the same names in files.
inline constexpr std::string_view kCryptomattePrefix = "cryptomatte/";

/// A fact about a picture, such as the number of its samples.
struct Attribute {
    std::string name;
    std::variant<std::string, int32_t, double> value;
};

/// The place of a cropped picture in the whole one, in pixels from the top left corner.
struct CropPlacement {
    uint32_t x = 0;
    uint32_t y = 0;
    uint32_t filmWidth = 0; ///< of the whole picture
    uint32_t filmHeight = 0;
};

/// The channel of a picture's alpha, in [0, 1]. The colour is multiplied by it already, as EXR
/// files have it. A picture without it is opaque.
inline constexpr std::string_view kAlphaChannel = "A";

/// The contents of a picture file.
struct Picture {
    Image color;
    std::vector<Channel> channels = {}; ///< without the colour; each has the colour's size
    std::vector<Attribute> metadata = {};
    std::optional<CropPlacement> crop = {}; ///< none: the picture is not cropped

    /// Of each pixel; empty for an opaque picture.
    std::span<const float> alpha() const;
    /// Nothing happens if `values` is empty.
    void setAlpha(std::vector<float> values);
};

} // namespace calotype
