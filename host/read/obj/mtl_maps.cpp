#include "read/obj/mtl_maps.h"

#include <bit>

#include "image/texel_values.h"
#include "mesh/bump_map.h"
#include "read/texture_file.h"

namespace calotype {
namespace {

bool areEqual(const Texture& a, const Texture& b) {
    const auto* imageA = std::get_if<ImageTexture>(&a.source);
    const auto* imageB = std::get_if<ImageTexture>(&b.source);
    return imageA != nullptr && imageB != nullptr && imageA->image == imageB->image &&
           imageA->wrap == imageB->wrap && imageA->filter == imageB->filter &&
           imageA->decodesColor == imageB->decodesColor && a.scale == b.scale &&
           a.offset == b.offset;
}

TexelImage normalMapOf(const TexelImage& image, const MtlTexture& map) {
    return isGrey(image) ? normalMapFromHeights(image, map.channel.value_or(TexelChannel::Red),
                                                map.bumpMultiplier)
                         : steepenedNormalMap(image, map.bumpMultiplier);
}

} // namespace

uint32_t MtlMaps::add(const MtlTexture& map, std::shared_ptr<const TexelImage> image) {
    Texture texture;
    texture.name = std::filesystem::path(map.file).filename().string();
    texture.scale = map.scale;
    texture.offset = map.offset;
    ImageTexture source;
    source.image = std::move(image);
    source.wrap = map.clamps ? TextureWrap::Clamp : TextureWrap::Repeat;
    source.decodesColor = !map.isLinear;
    texture.source = source;
    const std::vector<Texture>& textures = context_.scene.textures;
    for (size_t i = 0; i < textures.size(); ++i)
        if (areEqual(textures[i], texture))
            return static_cast<uint32_t>(i);
    return context_.addTexture(std::move(texture));
}

template <typename Convert>
uint32_t MtlMaps::converted(const MtlTexture& map, const std::filesystem::path& directory,
                            const std::string& recipe, Convert convert) {
    const TextureFile file = readTextureFile(map.file, directory, map.place, context_);
    if (!file.image)
        return Material::kNoTexture;
    // A zero separates path and recipe: paths cannot contain it.
    std::shared_ptr<const TexelImage>& cached =
        context_.images[file.path + std::string(1, '\0') + recipe];
    if (!cached)
        cached = std::make_shared<TexelImage>(convert(*file.image));
    return add(map, cached);
}

uint32_t MtlMaps::color(const MtlTexture& map, const std::filesystem::path& directory) {
    const TextureFile file = readTextureFile(map.file, directory, map.place, context_);
    return add(map, file.image ? file.image : magentaImage());
}

uint32_t MtlMaps::alpha(const MtlTexture& map, const std::filesystem::path& directory) {
    const std::string channel = map.channel ? std::to_string(static_cast<int>(*map.channel)) : "";
    return converted(map, directory, "alpha" + channel, [&](const TexelImage& image) {
        const auto usual = image.isTransparent ? TexelChannel::Alpha : TexelChannel::Red;
        return alphaImage(image, map.channel.value_or(usual));
    });
}

uint32_t MtlMaps::scalar(const MtlTexture& map, const std::filesystem::path& directory) {
    const auto channel = map.channel.value_or(TexelChannel::Red);
    return converted(map, directory, "grey" + std::to_string(static_cast<int>(channel)),
                     [&](const TexelImage& image) { return greyImage(image, channel); });
}

uint32_t MtlMaps::normals(const MtlTexture& map, const std::filesystem::path& directory) {
    const std::string recipe =
        "normals" + std::to_string(static_cast<int>(map.channel.value_or(TexelChannel::Red))) +
        ":" + std::to_string(std::bit_cast<uint64_t>(map.bumpMultiplier));
    const TextureFile file = readTextureFile(map.file, directory, map.place, context_);
    if (file.image && map.bumpMultiplier == 1.0 && !isGrey(*file.image))
        return add(map, file.image);
    return converted(map, directory, recipe,
                     [&](const TexelImage& image) { return normalMapOf(image, map); });
}

std::optional<glm::dvec3> MtlMaps::meanColor(const MtlTexture& map,
                                             const std::filesystem::path& directory) {
    const TextureFile file = readTextureFile(map.file, directory, map.place, context_);
    if (!file.image)
        return std::nullopt;
    return calotype::meanColor(*file.image, !map.isLinear);
}

bool MtlMaps::isTransparent(uint32_t texture) const {
    return std::get<ImageTexture>(context_.scene.textures[texture].source).image->isTransparent;
}

} // namespace calotype
