#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "image/denoiser_features.h"

namespace calotype {

// Features of denoisers in a film's file: the numbers of the albedo, then of the normal, as 32-bit
// floats in chunks of 2^18: the first bytes of all numbers of the chunk, then their second bytes,
// ...; compressed by zlib.

std::vector<std::string> compressedChunks(const DenoiserFeatures& features);

/// Of a picture of this size. Throws std::out_of_range if the chunks are not such ones.
DenoiserFeatures featuresFrom(const std::vector<std::string_view>& chunks, uint32_t width,
                              uint32_t height);

} // namespace calotype
