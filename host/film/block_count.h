#pragma once

#include <cstdint>

#include "shared/limits.h"

namespace calotype {

/// The samples of a pixel in a block.
struct BlockCount {
    uint32_t samples = 0;
    uint32_t hidden = 0; ///< of these, samples that show the background, hidden from the camera
};

static_assert(shared::kSamplesPerBlock * shared::kHiddenSample < 1.0f);

/// As a block holds it in its fourth channel (shared::kHiddenSample).
constexpr float blockCount(const BlockCount& count) {
    return static_cast<float>(count.samples) +
           shared::kHiddenSample * static_cast<float>(count.hidden);
}

/// The inverse, of a number >= 0.
constexpr BlockCount blockCountOf(float channel) {
    const auto samples = static_cast<uint32_t>(channel);
    return {samples,
            static_cast<uint32_t>((channel - static_cast<float>(samples)) / shared::kHiddenSample)};
}

} // namespace calotype
