#pragma once

#include <filesystem>
#include <string>

#include "image/image.h"

namespace calotype {

/// 16384 x 16384, which is 3 GiB as floats.
inline constexpr uint64_t kMostPicturePixels = uint64_t{1} << 28;

/// Reads an EXR (channels R, G and B of half or float), a colour PFM, a Radiance HDR (RGBE) or a
/// PNG (8 or 16 bits, decoded from sRGB) as linear light. The content decides the format. Ignores
/// alpha and other channels. Throws SceneError for a file that is missing, damaged, of another
/// format, or that has more than 65535 pixels on a side or `mostPixels` in all.
Image readImage(const std::filesystem::path& path, uint64_t mostPixels = kMostPicturePixels);

/// The first bytes of a file, by which its format is recognised. Throws SceneError if it cannot be
/// opened, or is no regular file.
std::string signatureOf(const std::filesystem::path& path);

} // namespace calotype
