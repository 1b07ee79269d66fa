#pragma once

#include <optional>

#include "scene/scene.h"
#include "scene/texture_ranges.h"

namespace calotype {

/// The share of the light from one direction, at `cosine` (in (0, 1]) to the normal, that the GGX
/// lobe of a nonmetal reflects: the integral of F D G / (4 n.l n.v) n.l over the hemisphere, to
/// about 0.001. `roughness` and `f0` in [0, 1].
double ggxAlbedo(double cosine, double roughness, double f0, Masking masking);

/// Whether the format's rule, kd + 4 ks > 1, decides for the material, whatever its colour: a
/// Blinn-Phong of constant colour that is not normalised.
bool isJudgedByWeights(const Material& material);

/// The share of the light from one direction that the material can reflect, where that is more than
/// all of it; nullopt where it is not. Blinn-Phong: kd + 4 ks by the format's rule, else kd times
/// the brightest colour + 4 ks, or + ks where it is normalised. Nonmetal: by numerical integration
/// up to an angle of 87 degrees, at which with Masking::Schlick and F0 = 0.04 colours from 0.88
/// (roughness 0) to 0.99 (roughness 0.8) exceed 1. Of textures the extremes are taken, which need
/// not meet in one place.
std::optional<double> excessAlbedo(const Material& material, TextureRanges& textures);

} // namespace calotype
