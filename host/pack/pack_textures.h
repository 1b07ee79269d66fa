#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "pack/texel_rows.h"
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
    /// The texels of all images, one after the other.
    std::vector<TexelRows> takeTexelRows() { return std::move(rows_); }

private:
    shared::Texture pack(const Texture& texture);
    uint32_t addTexels(std::shared_ptr<const TexelImage> image);

    std::span<const Texture> textures_;
    std::optional<TextureFilter> filter_;
    std::vector<shared::Texture> packed_;
    std::vector<TexelRows> rows_;
    size_t rowCount_ = 0;
    std::map<std::pair<uint32_t, bool>, uint32_t> packedIndex_; ///< by the arguments of add
    std::map<const TexelImage*, uint32_t> firstRow_;
};

} // namespace calotype
