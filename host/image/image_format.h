#pragma once

#include <filesystem>
#include <optional>
#include <string_view>

namespace calotype {

enum class ImageFormat {
    Png, ///< 8-bit sRGB
    Exr, ///< 32-bit float, linear
    Pfm, ///< 32-bit float, linear
};

/// The known extensions, for messages.
inline constexpr std::string_view kImageExtensions = ".png, .exr or .pfm";

/// The format of the extension of `path`, ignoring case; none if it is unknown.
std::optional<ImageFormat> imageFormatOf(const std::filesystem::path& path);

} // namespace calotype
