#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "engine/picture_denoiser.h"
#include "image/denoiser_features.h"
#include "image/picture.h"

namespace calotype {

/// A picture in an EXR file that is to be denoised.
struct NoisyPicture {
    Picture picture; ///< as the samples are, with the other layers and the metadata of the file
    std::optional<DenoiserFeatures> features;
    std::string warning; ///< about the features, a complete sentence; empty if they are the best
};

/// Reads the picture: of a file that was denoised before its layer "noisy". Throws SceneError if
/// the file cannot be read, is no EXR file, is denoised and has no such layer, has other primaries
/// than Rec. 709's, or has pixels that are not finite.
NoisyPicture readNoisyPicture(const std::filesystem::path& path);

/// The picture after denoising, with its layers and metadata.
Picture pictureOf(NoisyPicture noisy, const CleanPicture& clean);

} // namespace calotype
