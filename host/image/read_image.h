#pragma once

#include <filesystem>

#include "image/image.h"

namespace calotype {

/// Reads an EXR (channels R, G and B of half or float), a colour PFM, a Radiance HDR (RGBE) or a
/// PNG (8 or 16 bits, decoded from sRGB), told apart by their content, as linear light. Alpha and
/// other channels are left out. Throws SceneError for a file that is missing, damaged, of another
/// kind, or that holds more than 65535 pixels on a side or 2^28 in all.
Image readImage(const std::filesystem::path& path);

} // namespace calotype
