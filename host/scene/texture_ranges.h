#pragma once

#include <map>
#include <span>

#include <glm/vec3.hpp>

#include "image/texel_values.h"
#include "scene/texture.h"

namespace calotype {

struct ScalarRange {
    double least = 1.0;
    double greatest = 1.0;
};

/// The extremes of the values that materials can read from a scene's textures, at any texture
/// coordinates. Filters do not exceed them. Each image is scanned once.
class TextureRanges {
public:
    explicit TextureRanges(std::span<const Texture> textures) : textures_(textures) {}

    /// The greatest value of each channel that a colour slot reads: linear, in [0, 1]. 1 for
    /// Material::kNoTexture.
    glm::dvec3 brightest(uint32_t texture);

    /// The range of values that a scalar slot reads: the first channel, in [0, 1]. From 1 to 1 for
    /// Material::kNoTexture.
    ScalarRange scalars(uint32_t texture);

private:
    const TexelRange& rangeOf(const TexelImage& image);

    std::span<const Texture> textures_;
    std::map<const TexelImage*, TexelRange> ranges_;
};

} // namespace calotype
