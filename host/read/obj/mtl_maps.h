#pragma once

#include <filesystem>

#include "read/obj/mtl_texture.h"
#include "read/read_context.h"

namespace calotype {

/// Makes textures of the scene from textures of MTL files; equal ones are merged. Functions with a
/// map throw SceneError like readTextureFile and, unless stated otherwise, return an index into
/// Scene::textures. `directory` is that of the MTL file.
class MtlMaps {
public:
    explicit MtlMaps(ReadContext& context) : context_(context) {}

    /// A missing image is shown as magenta.
    uint32_t color(const MtlTexture& map, const std::filesystem::path& directory);
    /// A texture whose alpha is the channel that -imfchan names; else the image's alpha or, if it
    /// is opaque, its first channel. Material::kNoTexture for a missing image, also below.
    uint32_t alpha(const MtlTexture& map, const std::filesystem::path& directory);
    /// A texture whose first channel is that of -imfchan.
    uint32_t scalar(const MtlTexture& map, const std::filesystem::path& directory);
    /// A normal map: the image itself or, if it is grey (see isGrey), made from it as heights.
    uint32_t normals(const MtlTexture& map, const std::filesystem::path& directory);

    /// The mean colour of the image, linear; nullopt for a missing image.
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
