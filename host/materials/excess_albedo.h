#pragma once

#include <optional>
#include <string>

#include "scene/scene.h"
#include "scene/texture_ranges.h"

namespace calotype {

/// The largest share of the light from one direction that the material can reflect, if it is above
/// 1; else nullopt. Uses the extremes of textures, which need not be at the same place.
std::optional<double> excessAlbedo(const Material& material, TextureRanges& textures);

/// The largest channel of a material's colour, at the brightest texel of its texture.
double brightestChannel(const Material& material, TextureRanges& textures);

/// `albedo` if it is above `limit`.
std::optional<double> whereAbove(double limit, double albedo);

/// "101.4 %"
std::string albedoText(double albedo);

} // namespace calotype
