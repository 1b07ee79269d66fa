#pragma once

#include <cstdint>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "settings/sampler.h"

namespace calotype::reference {

/// What a path's random numbers depend on. Sample indices are absolute.
struct SampleId {
    glm::uvec2 pixel{0}; ///< on the whole film, below 65536 each
    uint32_t sampleIndex = 0;
    uint32_t seed = 0;
    Sampler sampler = Sampler::Independent;
};

/// A path's random numbers in groups of four, numbered as on the device: eight groups before the
/// first bounce, the first of which is for the camera, then eight groups for each bounce.
enum class BounceDimension : uint32_t {
    Light = 0, ///< choice of a light and a point on it
    Bsdf = 1,  ///< direction of the next ray, choice of a lobe
    Alpha = 2, ///< which surfaces up to the next event let light through
};

/// Four numbers in [0, 1), multiples of 2^-24, for the position on film and lens: independent, or
/// two of Sobol's points.
glm::dvec4 cameraNumbers(const SampleId& id);

/// The same for the event `bounce` of the path.
glm::dvec4 bounceNumbers(const SampleId& id, uint32_t bounce, BounceDimension dimension);

/// Four independent numbers in [0, 1) for a point on each light, if all lights are sampled.
glm::dvec4 lightNumbers(const SampleId& id, uint32_t bounce, uint32_t light);

/// One number in [0, 1), a different one for each `item`.
double alphaNumber(const SampleId& id, uint32_t bounce, uint32_t item);

} // namespace calotype::reference
