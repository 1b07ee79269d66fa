#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <tuple>

#include "read/obj/mtl_texture.h"
#include "read/read_context.h"

namespace calotype {

/// How the picture of a bump statement is read.
enum class BumpKind : uint8_t { Missing, Normals, Heights, ColoredHeights };

/// What is known of the textures and images of a scene, so that no material looks at all of them.
struct MtlMapCache {
    using Key = std::tuple<const TexelImage*, TextureWrap, TextureFilter, bool, double, double,
                           double, double>;
    std::map<Key, uint32_t> textures; ///< by all that makes them differ: the first of these
    size_t seenTextures = 0;          ///< how many of Scene::textures are in `textures`
    std::map<const TexelImage*, BumpKind> bumpKinds;
    std::map<std::tuple<const TexelImage*, bool, AlphaWeights>, glm::dvec3>
        meanColors; ///< true: decoded
    std::map<std::pair<const TexelImage*, TexelChannel>, double> means;
};

/// Makes textures of the scene from textures of MTL files; equal ones are merged. Functions with a
/// map throw SceneError like readTextureFile and, unless stated otherwise, return an index into
/// Scene::textures. `directory` is that of the MTL file.
class MtlMaps {
public:
    MtlMaps(MtlMapCache& cache, ReadContext& context) : cache_(cache), context_(context) {}

    /// A missing image is shown as magenta.
    uint32_t color(const MtlTexture& map, const std::filesystem::path& directory);
    /// A texture whose alpha is the channel that -imfchan names; else the image's alpha or, if it
    /// is opaque, its first channel. Material::kNoTexture for a missing image, also below.
    uint32_t alpha(const MtlTexture& map, const std::filesystem::path& directory);
    /// A texture whose first channel is that of -imfchan.
    uint32_t scalar(const MtlTexture& map, const std::filesystem::path& directory);
    /// The image as a normal map.
    uint32_t normals(const MtlTexture& map, const std::filesystem::path& directory);
    /// A normal map that is made from the heights in the channel of -imfchan; without that option
    /// from the luminance.
    uint32_t heights(const MtlTexture& map, const std::filesystem::path& directory);

    /// Normals if the image looks like a normal map (see looksLikeNormals).
    BumpKind bumpKind(const MtlTexture& map, const std::filesystem::path& directory);
    /// The mean colour of the image, linear; nullopt for a missing image.
    std::optional<glm::dvec3>
    meanColor(const MtlTexture& map, const std::filesystem::path& directory, AlphaWeights weights);
    /// The mean of the channel of -imfchan, not decoded; nullopt for a missing image.
    std::optional<double> mean(const MtlTexture& map, const std::filesystem::path& directory);

    bool isTransparent(uint32_t texture) const;

private:
    template <typename Convert>
    uint32_t converted(const MtlTexture& map, const std::filesystem::path& directory,
                       const std::string& recipe, Convert convert);
    uint32_t add(const MtlTexture& map, std::shared_ptr<const TexelImage> image);

    MtlMapCache& cache_;
    ReadContext& context_;
};

} // namespace calotype
