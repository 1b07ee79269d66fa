#pragma once

#include <bit>
#include <cstdint>

#include "settings/limits.h"
#include "shared/limits.h"

namespace calotype {

/// The numbers of samples per pixel at which an error is compared with a goal ("looks"): 128, and
/// from there the multiples of 16 with at most four significant bits, so 144, 160, ... 256, 288,
/// ... Each is at most an eighth larger than the one before.

/// One block of every replica.
inline constexpr uint64_t kFirstLook = uint64_t{shared::kReplicas} * shared::kSamplesPerBlock;

inline constexpr int kLooksPerDoubling = 8;

/// From the first to the largest number of samples.
inline constexpr int kLooks =
    kLooksPerDoubling * (std::bit_width(uint64_t{kMostSamplesPerPixel} / kFirstLook) - 1) + 1;

/// The one-sided normal quantile of 1 - 0.05 / 153: the level of 5 % is divided by the looks.
inline constexpr double kSharedQuantile = 3.4084;
static_assert(kLooks == 153);

/// The first look that is greater than `samples`.
constexpr uint64_t lookAfter(uint64_t samples) {
    if (samples < kFirstLook)
        return kFirstLook;
    const uint64_t step = std::bit_floor(samples) / kLooksPerDoubling;
    return (samples / step + 1) * step;
}

constexpr bool isLook(uint64_t samples) {
    return samples >= kFirstLook && lookAfter(samples - 1) == samples;
}

} // namespace calotype
