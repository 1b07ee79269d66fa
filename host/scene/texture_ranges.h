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

/// The extremes of what materials read from a scene's textures, wherever their texture coordinates
/// lie. Filters do not exceed them. Each image is looked through once.
class TextureRanges {
public:
    explicit TextureRanges(std::span<const Texture> textures) : textures_(textures) {}

    /// Of each channel the greatest that a colour slot reads: linear, in [0, 1]. 1 for
    /// Material::kNoTexture.
    glm::dvec3 brightest(uint32_t texture);

    /// What a scalar slot reads: the first channel, in [0, 1]. From 1 to 1 for
    /// Material::kNoTexture.
    ScalarRange scalars(uint32_t texture);

private:
    const TexelRange& rangeOf(const TexelImage& image);

    std::span<const Texture> textures_;
    std::map<const TexelImage*, TexelRange> ranges_;
};

} // namespace calotype
