#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "image/picture.h"

/// Mattes in EXR files by the Cryptomatte specification, version 1.2.0 (Friedman and Jones 2015,
/// "Fully automatic ID mattes with support for motion blur and transparency"): a pixel has up to
/// kCryptomatteRanks pairs of a name's hash and the share of the pixel that it covers, the largest
/// share first.
namespace calotype {

inline constexpr uint32_t kCryptomatteRanks = 6;

/// MurmurHash3_x86_32 (Appleby 2011) of the bytes.
uint32_t murmurHash3(std::string_view bytes, uint32_t seed = 0);

/// The id of a name: its hash as the bits of a float. A bit of the exponent is changed where the
/// hash is no normal number ("uint32_to_float32").
float cryptomatteId(std::string_view name);

/// The names of a layer's channels: "CryptoObject00.R" to "CryptoObject02.A". In each group R and B
/// are ids, G and A the shares of the same ranks.
std::vector<std::string> cryptomatteChannels(const std::string& typeName);

/// The attributes of a layer, with the ids of all names (the manifest), which are in UTF-8. The
/// names of the attributes begin with kCryptomattePrefix.
std::vector<Attribute> cryptomatteAttributes(const std::string& typeName,
                                             std::span<const std::string> names);

} // namespace calotype
