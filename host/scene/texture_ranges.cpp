#include "scene/texture_ranges.h"

#include <algorithm>

#include <glm/common.hpp>

#include "image/srgb.h"
#include "scene/scene.h"

namespace calotype {
namespace {

glm::dvec3 decoded(const glm::dvec3& encoded) {
    return {linearFromSrgb(encoded.x), linearFromSrgb(encoded.y), linearFromSrgb(encoded.z)};
}

} // namespace

const TexelRange& TextureRanges::rangeOf(const TexelImage& image) {
    const auto [entry, isNew] = ranges_.try_emplace(&image);
    if (isNew)
        entry->second = texelRange(image);
    return entry->second;
}

glm::dvec3 TextureRanges::brightest(uint32_t texture) {
    if (texture == Material::kNoTexture)
        return glm::dvec3(1.0);
    if (const auto* checker = std::get_if<CheckerTexture>(&textures_[texture].source))
        return glm::max(checker->colors[0], checker->colors[1]);
    const auto& source = std::get<ImageTexture>(textures_[texture].source);
    const glm::dvec3 stored = glm::clamp(rangeOf(*source.image).greatest, 0.0, 1.0);
    return source.decodesColor && source.image->isEncoded ? decoded(stored) : stored;
}

ScalarRange TextureRanges::scalars(uint32_t texture) {
    if (texture == Material::kNoTexture)
        return {};
    if (const auto* checker = std::get_if<CheckerTexture>(&textures_[texture].source)) {
        const auto [least, greatest] = std::minmax(checker->colors[0].x, checker->colors[1].x);
        return {least, greatest};
    }
    const TexelRange& stored = rangeOf(*std::get<ImageTexture>(textures_[texture].source).image);
    return {std::clamp(stored.least.x, 0.0, 1.0), std::clamp(stored.greatest.x, 0.0, 1.0)};
}

} // namespace calotype
