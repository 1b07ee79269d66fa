#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"

namespace calotype {

/// The share of the light from one direction, at `cosine` (in (0, 1]) to the normal, that the GGX
/// lobe of a nonmetal reflects: the integral of F D G / (4 n.l n.v) n.l over the hemisphere, to
/// about 0.001. `roughness` and `f0` in [0, 1].
double ggxAlbedo(double cosine, double roughness, double f0, Masking masking);

/// A sentence that says so where the material reflects more than it receives; nullopt where it does
/// not. Blinn-Phong by its weights: kd + 4 ks, or kd + ks where it is normalised, above 1. Nonmetal
/// by numerical integration up to an angle of 87 degrees, at which with the report's masking and
/// F0 = 0.04 colours from 0.88 (roughness 0) to 0.99 (roughness 0.8) exceed 1. Of textures it takes
/// what reflects least, so that the sentence is true whatever they hold.
std::optional<std::string> energyWarning(const Material& material);

} // namespace calotype
