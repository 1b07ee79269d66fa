#pragma once

#include <cstdint>

#include "settings/crop.h"
#include "settings/sampler.h"
#include "settings/transport.h"

namespace calotype {

struct RenderSettings {
    uint32_t width = 0; ///< of the whole film, pixels
    uint32_t height = 0;
    Crop crop;                ///< what is rendered of it; within the film, not empty
    uint32_t firstSample = 0; ///< absolute index; a multiple of shared::kSamplesPerBlock
    uint32_t samplesPerPixel = 0;
    uint32_t maxBounces = 0;
    uint32_t seed = 0;
    Sampler sampler = Sampler::Independent;
    TransportSettings transport = {};
};

} // namespace calotype
