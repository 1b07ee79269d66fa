#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "scene/texture.h"

namespace calotype::test {

/// The scene format's words on textures in double precision: an image is a lattice of texels that
/// reaches everywhere, each texel found by its integer column and row; nothing is folded before.
///
/// RGB and alpha at a position of the source (texture coordinates after scale and offset). `decode`
/// gives linear colours, as a colour slot does.
glm::dvec4 oracleTexture(const Texture& texture, const glm::dvec2& position, bool decode);

/// The colour of an image where a surface has holes by its alpha: the mean of the texels weighted
/// by their alpha and by the filter; without alpha where all of them are transparent.
glm::dvec3 oracleCutOutColor(const Texture& texture, const glm::dvec2& position, bool decode);

/// IEC 61966-2-1: the linear value of an encoded one in [0, 1].
double oracleLinearFromSrgb(double encoded);

} // namespace calotype::test
