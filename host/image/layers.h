#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "image/coverage.h"
#include "image/features.h"
#include "image/first_hit.h"
#include "image/layer.h"
#include "image/picture.h"
#include "image/pixel_error.h"

namespace calotype {

/// The channels of a layer whose source is FirstHit.
std::vector<Channel> channelsOf(const Layer& layer, const FirstHitImage& hits);

/// The channels of a layer whose source is Averaged.
std::vector<Channel> channelsOf(const Layer& layer, const FeatureImage& features);

/// The channels of a layer whose source is Replicas.
std::vector<Channel> channelsOf(const Layer& layer, std::span<const PixelError> errors);

/// The channels of a layer whose source is Mattes. `ids` has that of each thing of the coverage.
std::vector<Channel> channelsOf(const Layer& layer, const Coverage& coverage,
                                std::span<const float> ids);

/// Reads the first-hit layers in an EXR file; a layer that the file lacks gets the default values
/// of a FirstHit. Throws SceneError if the file cannot be read, is damaged, or has no such layer.
FirstHitImage readFirstHits(const std::filesystem::path& path);

} // namespace calotype
