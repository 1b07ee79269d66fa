#pragma once

#include <filesystem>

#include "film/display_transform.h"
#include "image/picture.h"

namespace calotype {

/// Writes a picture, atomically, in the format of the extension of `path` (image/image_format.h):
/// PNG holds the colour through `transform`, and whether it is denoised; PFM the colour as it is,
/// EXR everything. Throws OutputError, also for an unknown extension.
void writePicture(const std::filesystem::path& path, const Picture& picture,
                  const DisplayTransform& transform);

} // namespace calotype
