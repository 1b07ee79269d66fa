#include "pack/pack_textures.h"

#include <utility>

#include "base/error.h"

namespace calotype {
namespace {

/// Rows are numbered by 32 bits, and fetched by signed integers.
constexpr size_t kMostRows = size_t{1} << 31;

uint32_t flagsOf(const ImageTexture& texture, TextureFilter filter) {
    uint32_t flags = texture.image->holdsBytes() ? 0 : shared::kTextureHoldsFloats;
    if (texture.decodesColor && texture.image->isEncoded)
        flags |= shared::kTextureIsEncoded;
    if (filter == TextureFilter::Nearest)
        flags |= shared::kTextureIsNearest;
    if (texture.wrap == TextureWrap::Clamp)
        flags |= shared::kTextureClamps;
    if (texture.wrap == TextureWrap::Mirror)
        flags |= shared::kTextureMirrors;
    return flags;
}

} // namespace

uint32_t TexturePacker::add(uint32_t texture, bool isCutOut) {
    const auto next = static_cast<uint32_t>(packed_.size());
    const auto [entry, isNew] = packedIndex_.try_emplace({texture, isCutOut}, next);
    if (isNew) {
        packed_.push_back(pack(textures_[texture]));
        packed_.back().flags |= isCutOut ? shared::kTextureIsCutOut : 0;
    }
    return entry->second;
}

shared::Texture TexturePacker::pack(const Texture& texture) {
    shared::Texture packed{};
    packed.scale = glm::vec2(texture.scale);
    packed.offset = glm::vec2(texture.offset);
    if (const auto* checker = std::get_if<CheckerTexture>(&texture.source)) {
        packed.flags = shared::kTextureIsChecker;
        packed.color0 = glm::vec3(checker->colors[0]);
        packed.color1 = glm::vec3(checker->colors[1]);
        return packed;
    }
    const auto& source = std::get<ImageTexture>(texture.source);
    packed.firstRow = addTexels(source.image);
    packed.width = source.image->width;
    packed.height = source.image->height;
    packed.flags = flagsOf(source, filter_.value_or(source.filter));
    return packed;
}

uint32_t TexturePacker::addTexels(std::shared_ptr<const TexelImage> image) {
    const auto [entry, isNew] =
        firstRow_.try_emplace(image.get(), static_cast<uint32_t>(rowCount_));
    if (!isNew)
        return entry->second;
    rows_.push_back({std::move(image)});
    rowCount_ += rows_.back().count();
    if (rowCount_ > kMostRows)
        throw GpuError("the scene's textures have more texels than the kernels can address");
    return entry->second;
}

} // namespace calotype
