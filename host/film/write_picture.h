#pragma once

#include <filesystem>

#include "film/display_transform.h"
#include "image/picture.h"

namespace calotype {

/// Writes a picture in the format that the extension of `path` names (image/image_format.h), whole
/// at every moment: PNG holds its colour through `transform`, PFM its colour as it is, EXR all of
/// it. Throws OutputError, also for an extension that is not known.
void writePicture(const std::filesystem::path& path, const Picture& picture,
                  const DisplayTransform& transform);

} // namespace calotype
