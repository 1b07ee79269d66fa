#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "image/texel_image.h"
#include "settings/texture_filter.h"

namespace calotype {

enum class TextureWrap : uint8_t { Repeat, Clamp, Mirror };

struct ImageTexture {
    static constexpr uint32_t kLargestSide = 16384;

    std::shared_ptr<const TexelImage> image;
    TextureWrap wrap = TextureWrap::Repeat;
    TextureFilter filter = TextureFilter::Bilinear;
    bool decodesColor = true; ///< colour slots decode sRGB before filtering; no other slot does
};

/// The first colour where floor(u) + floor(v) is even.
struct CheckerTexture {
    std::array<glm::dvec3, 2> colors{};
};

/// A colour (and alpha) over texture coordinates. v = 0 is the bottom of an image; texel centres
/// are at (i + 1/2) / n.
struct Texture {
    std::string name;
    std::variant<ImageTexture, CheckerTexture> source;
    glm::dvec2 scale{1.0}; ///< the source is read at uv * scale + offset
    glm::dvec2 offset{0.0};
    bool isMissing = false; ///< its file is missing or unreadable, and magenta replaces it
};

} // namespace calotype
