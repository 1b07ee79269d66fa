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

/// The extensions that are known, for messages.
inline constexpr std::string_view kImageExtensions = ".png, .exr or .pfm";

/// The format that the extension of `path` names, in whatever case; none if it is not known.
std::optional<ImageFormat> imageFormatOf(const std::filesystem::path& path);

} // namespace calotype
