#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec4.hpp>

#include "scene/texture.h"
#include "shared/scene_structs.h"

namespace calotype {

/// Packs the textures that a scene's materials use, and the texels of each image once.
class TexturePacker {
public:
    /// `filter` replaces that of each texture, if there is one.
    explicit TexturePacker(std::span<const Texture> textures,
                           std::optional<TextureFilter> filter = {})
        : textures_(textures), filter_(filter) {}

    /// The packed index of a texture. Packs the texture at the first call. `isCutOut`: filters
    /// weigh the colour of a texel by its alpha (see hasCutOutColors).
    uint32_t add(uint32_t texture, bool isCutOut = false);

    std::vector<shared::Texture> takePacked() { return std::move(packed_); }
    /// Rows of 16 bytes: four texels of 8-bit RGBA, or one of four floats.
    std::vector<glm::uvec4> takeTexelRows() { return std::move(rows_); }

private:
    shared::Texture pack(const Texture& texture);
    uint32_t addTexels(const TexelImage& image);

    std::span<const Texture> textures_;
    std::optional<TextureFilter> filter_;
    std::vector<shared::Texture> packed_;
    std::vector<glm::uvec4> rows_;
    std::map<std::pair<uint32_t, bool>, uint32_t> packedIndex_; ///< by the arguments of add
    std::map<const TexelImage*, uint32_t> firstRow_;
};

} // namespace calotype
