#pragma once

#include <cstdint>

#include "scene/scene.h"

namespace calotype {

/// The packed GGX lobe of a metal or nonmetal.
uint32_t ggxLobe(const Material& material);

/// The share of the light from one direction, at `cosine` (in (0, 1]) to the normal, that the GGX
/// lobe of a nonmetal reflects: the integral of F D G / (4 n.l n.v) n.l over the hemisphere, to
/// about 0.001. `roughness` and `f0` in [0, 1].
double ggxAlbedo(double cosine, double roughness, double f0, Masking masking);

} // namespace calotype
