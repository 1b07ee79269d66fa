#pragma once

#include <cstdint>
#include <optional>

#include "settings/bvh_builder.h"
#include "settings/crop.h"
#include "settings/denoiser_kind.h"
#include "settings/sampler.h"
#include "settings/texture_filter.h"
#include "settings/transport.h"

namespace calotype {

/// How a picture is rendered: all settings that can be chosen for a scene.
struct RenderSettings {
    uint32_t width = 0; ///< of the whole film, pixels
    uint32_t height = 0;
    Crop crop; ///< the part that is rendered, inside the film; for Renderer, {} is all of it
    uint32_t firstSample = 0;     ///< absolute index; a multiple of shared::kSamplesPerBlock
    uint32_t samplesPerPixel = 0; ///< 1 to kMostSamplesPerPixel; with isAdaptive the mean
    uint32_t maxBounces = 0;      ///< scattering events along a path, 0 to kMostBounces
    uint32_t seed = 0;
    Sampler sampler = Sampler::Sobol;
    TransportSettings transport = {};
    std::optional<TextureFilter> textureFilter = {}; ///< of all textures; none: each its own
    std::optional<BvhBuilder> bvh = {};              ///< none: the quickest for the samples
    /// Pixels with more error get more samples; firstSample must be 0.
    bool isAdaptive = false;
    /// What removes the noise of the finished picture.
    DenoiserKind denoiser = DenoiserKind::Off;
    bool compilesEverything = false; ///< the kernel with all features, not only those of the scene
    /// The render ends when ErrorEstimate::upperBound is at most this, in (0, 1).
    std::optional<double> targetError = {};
    std::optional<double> seconds = {}; ///< the render ends then; above 0, up to kMostSeconds
};

} // namespace calotype
