#include "read/obj/mtl_maps.h"

#include <bit>

#include "image/texel_values.h"
#include "mesh/bump_map.h"
#include "read/texture_file.h"

namespace calotype {
namespace {

MtlMapCache::Key keyOf(const Texture& texture, const ImageTexture& image) {
    return {image.image.get(), image.wrap,      image.filter,     image.decodesColor,
            texture.scale.x,   texture.scale.y, texture.offset.x, texture.offset.y};
}

std::string steepnessRecipe(const MtlTexture& map) {
    return ":" + std::to_string(std::bit_cast<uint64_t>(map.bumpMultiplier));
}

/// The value of `cache` at `key`, which `compute` makes if it is not there.
template <typename Cache, typename Compute>
auto cached(Cache& cache, const typename Cache::key_type& key, Compute compute) {
    const auto found = cache.find(key);
    return found != cache.end() ? found->second : cache.emplace(key, compute()).first->second;
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
    for (size_t& i = cache_.seenTextures; i < textures.size(); ++i)
        if (const auto* seen = std::get_if<ImageTexture>(&textures[i].source))
            cache_.textures.try_emplace(keyOf(textures[i], *seen), static_cast<uint32_t>(i));
    const auto found = cache_.textures.find(keyOf(texture, source));
    return found != cache_.textures.end() ? found->second : context_.addTexture(std::move(texture));
}

template <typename Convert>
uint32_t MtlMaps::converted(const MtlTexture& map, const std::filesystem::path& directory,
                            const std::string& recipe, Convert convert) {
    const TextureFile file = readTextureFile(map.file, directory, map.place, context_);
    if (!file.image)
        return Material::kNoTexture;
    // A zero separates path and recipe: paths cannot contain it.
    std::shared_ptr<const TexelImage>& image =
        context_.images[file.path + std::string(1, '\0') + recipe];
    if (!image)
        image = std::make_shared<TexelImage>(convert(*file.image));
    return add(map, image);
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
    if (map.bumpMultiplier != 1.0) {
        return converted(
            map, directory, "normals" + steepnessRecipe(map),
            [&](const TexelImage& image) { return steepenedNormalMap(image, map.bumpMultiplier); });
    }
    const TextureFile file = readTextureFile(map.file, directory, map.place, context_);
    return file.image ? add(map, file.image) : Material::kNoTexture;
}

uint32_t MtlMaps::heights(const MtlTexture& map, const std::filesystem::path& directory) {
    const auto channel = map.channel.value_or(TexelChannel::Luminance);
    return converted(map, directory,
                     "heights" + std::to_string(static_cast<int>(channel)) + steepnessRecipe(map),
                     [&](const TexelImage& image) {
                         return normalMapFromHeights(image, channel, map.bumpMultiplier);
                     });
}

BumpKind MtlMaps::bumpKind(const MtlTexture& map, const std::filesystem::path& directory) {
    const auto image = readTextureFile(map.file, directory, map.place, context_).image;
    if (!image)
        return BumpKind::Missing;
    return cached(cache_.bumpKinds, image.get(), [&] {
        if (looksLikeNormals(*image))
            return BumpKind::Normals;
        return isGrey(*image) ? BumpKind::Heights : BumpKind::ColoredHeights;
    });
}

std::optional<glm::dvec3> MtlMaps::meanColor(const MtlTexture& map,
                                             const std::filesystem::path& directory,
                                             AlphaWeights weights) {
    const auto image = readTextureFile(map.file, directory, map.place, context_).image;
    if (!image)
        return std::nullopt;
    return cached(cache_.meanColors, {image.get(), !map.isLinear, weights},
                  [&] { return calotype::meanColor(*image, !map.isLinear, weights); });
}

std::optional<double> MtlMaps::mean(const MtlTexture& map, const std::filesystem::path& directory) {
    const auto image = readTextureFile(map.file, directory, map.place, context_).image;
    if (!image)
        return std::nullopt;
    const auto channel = map.channel.value_or(TexelChannel::Red);
    return cached(cache_.means, {image.get(), channel},
                  [&] { return calotype::meanColor(greyImage(*image, channel), false).x; });
}

bool MtlMaps::isTransparent(uint32_t texture) const {
    return std::get<ImageTexture>(context_.scene.textures[texture].source).image->isTransparent;
}

} // namespace calotype
