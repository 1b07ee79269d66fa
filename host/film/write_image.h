#pragma once

#include <filesystem>

#include "film/display_transform.h"
#include "image/exr.h"
#include "image/image.h"

namespace calotype {

/// Writes `image` in the format that the extension of `path` names (image/image_format.h), whole at
/// every moment: PNG through `transform`; EXR, with `metadata` and `layers`, and PFM as they are.
/// Throws OutputError, also for an extension that is not known.
void writeImage(const std::filesystem::path& path, const Image& image,
                const DisplayTransform& transform, const ExrMetadata& metadata,
                const ExrLayers& layers = {});

} // namespace calotype
