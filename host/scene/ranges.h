#pragma once

#include <cstdint>
#include <limits>

#include "base/range.h"
#include "image/image.h"
#include "settings/limits.h"

/// The range of each number of a Scene, used by readers, the JSON schema and validate.
namespace calotype::ranges {

inline constexpr Range kAnyNumber = {};
inline constexpr Range kPositive = greaterThan(0.0);

/// Degrees.
inline constexpr Range kFieldOfView = openRange(0.0, 180.0);
/// Metres.
inline constexpr Range kLensRadius = atLeast(0.0);

/// Each channel of a reflectance, a tint or an F0; also roughness, opacity, kd and ks.
inline constexpr Range kShare = closedRange(0.0, 1.0);
/// W/(m^2 sr), or W, of each channel.
inline constexpr Range kRadiance = atLeast(0.0);
/// W/(m^2 sr) of the brightest channel of an emitter, if it is not 0: kernels compute in floats.
inline constexpr Range kEmitter = closedRange(1e-30, 1e30);
/// Far beyond any real material's; the square of a ratio stays within float.
inline constexpr Range kIndexOfRefraction = closedRange(0.01, 100.0);

/// Texture coordinates, and the offsets that textures apply to them. At the limit floats are 64
/// apart, so that all lookups read the same texel; products of a few coordinates stay far below the
/// end of float's range (3.4e38).
inline constexpr Range kTextureCoordinate = closedRange(-1e9, 1e9);
/// Factors that textures apply to texture coordinates in scene files.
inline constexpr Range kTextureScale = {0.0, 1e9, true, false};

/// Whole numbers from `low` to `high`.
struct WholeRange {
    uint32_t low;
    uint32_t high;

    constexpr bool contains(uint32_t number) const { return number >= low && number <= high; }
};

inline constexpr WholeRange kPictureSide = {1, kLargestPictureSide};
inline constexpr WholeRange kSamplesPerPixel = {1, kMostSamplesPerPixel};
inline constexpr WholeRange kMaxBounces = {0, kMostBounces};
inline constexpr WholeRange kSeed = {0, std::numeric_limits<uint32_t>::max()};

} // namespace calotype::ranges
