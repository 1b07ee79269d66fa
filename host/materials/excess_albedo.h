#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/texture_ranges.h"

namespace calotype {

/// The share of the light from one direction that the material can reflect, where that is more than
/// all of it; nullopt where it is not. Of textures the extremes are taken, which need not meet in
/// one place.
std::optional<double> excessAlbedo(const Material& material, TextureRanges& textures);

/// The largest channel of a material's colour, where its texture is brightest.
double brightestChannel(const Material& material, TextureRanges& textures);

/// `albedo` where it is above `limit`.
std::optional<double> whereAbove(double limit, double albedo);

/// "101.4 %"
std::string albedoText(double albedo);

} // namespace calotype
