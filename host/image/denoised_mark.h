#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "image/picture.h"

namespace calotype {

/// What the metadata of a picture say of its denoising.
struct DenoisedMark {
    std::string denoiser;        ///< with its version
    std::optional<double> error; ///< relative, as DenoisedError; none: not stated
    std::optional<double> bound;
};

void addMark(const DenoisedMark& mark, std::vector<Attribute>& metadata);
void removeMark(std::vector<Attribute>& metadata);

/// None if the picture is not denoised.
std::optional<DenoisedMark> markOf(const std::vector<Attribute>& metadata);

/// Of an EXR or PNG file; none for files of other formats. Throws SceneError if it cannot be read.
std::optional<DenoisedMark> readMark(const std::filesystem::path& path);

} // namespace calotype
