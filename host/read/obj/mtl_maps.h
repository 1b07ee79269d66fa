#pragma once

#include <filesystem>

#include "read/obj/mtl_texture.h"
#include "read/read_context.h"

namespace calotype {

/// Textures of MTL files as textures of the scene; equal ones are one. What takes a map throws
/// SceneError as readTextureFile does and, unless it says otherwise, returns an index into
/// Scene::textures. `directory` is the MTL file's.
class MtlMaps {
public:
    explicit MtlMaps(ReadContext& context) : context_(context) {}

    /// A missing image shows as magenta.
    uint32_t color(const MtlTexture& map, const std::filesystem::path& directory);
    /// Texture whose alpha is the image's alpha, or its first channel where it is opaque, or the
    /// channel that -imfchan names. Material::kNoTexture for a missing image, as below.
    uint32_t alpha(const MtlTexture& map, const std::filesystem::path& directory);
    /// Texture whose first channel is that of -imfchan.
    uint32_t scalar(const MtlTexture& map, const std::filesystem::path& directory);
    /// Normal map: the image itself, or made of its heights where it is grey (see isGrey).
    uint32_t normals(const MtlTexture& map, const std::filesystem::path& directory);

    /// The colour that the image has on average, linear; nullopt for a missing image.
    std::optional<glm::dvec3> meanColor(const MtlTexture& map,
                                        const std::filesystem::path& directory);

    bool isTransparent(uint32_t texture) const;

private:
    template <typename Convert>
    uint32_t converted(const MtlTexture& map, const std::filesystem::path& directory,
                       const std::string& recipe, Convert convert);
    uint32_t add(const MtlTexture& map, std::shared_ptr<const TexelImage> image);

    ReadContext& context_;
};

} // namespace calotype
