#pragma once

#include <filesystem>
#include <vector>

#include "image/picture.h"

namespace calotype {

/// Writes the colour as channels R, G and B of 32-bit float, and the picture's other channels under
/// their names, bit for bit, compressed by ZIP, atomically. Metadata become attributes whose names
/// start with "calotype:", or with "cryptomatte/" if they do already. The display window is the
/// whole picture, the data window the crop. Throws OutputError.
void writeExr(const std::filesystem::path& path, const Picture& picture);

/// Reads the data window of channels R, G and B, of half or float. Throws SceneError if the file
/// cannot be read, is damaged, or lacks one of the three.
Image readExr(const std::filesystem::path& path);

/// Reads also all other channels with one value per pixel, integers as integers, half and float as
/// floats; the attributes that writeExr writes; and the crop, if the data window is a part of the
/// display window.
Picture readExrPicture(const std::filesystem::path& path);

/// Whether the file names other primaries, or another white point, than those of Rec. 709, as which
/// its colours are read. Throws SceneError likewise.
bool hasOtherPrimaries(const std::filesystem::path& path);

/// Reads only the attributes that writeExr writes. Throws SceneError likewise.
std::vector<Attribute> readExrMetadata(const std::filesystem::path& path);

} // namespace calotype
