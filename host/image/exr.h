#pragma once

#include <filesystem>

#include "image/picture.h"

namespace calotype {

/// Writes the colour as channels R, G and B of 32-bit float, and the picture's other channels under
/// their names, bit for bit, compressed by ZIP, whole at every moment. Metadata become attributes
/// whose names begin with "calotype:". The display window is the whole picture, the data window the
/// crop. Throws OutputError.
void writeExr(const std::filesystem::path& path, const Picture& picture);

/// Reads the data window of channels R, G and B, of half or float. Throws SceneError where the file
/// cannot be read, is damaged, or lacks one of the three.
Image readExr(const std::filesystem::path& path);

/// Likewise, with all other channels of one value per pixel: of integers, or, half or float, of
/// floats. The metadata and the crop are not read.
Picture readExrPicture(const std::filesystem::path& path);

} // namespace calotype
