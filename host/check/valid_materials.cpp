#include "check/valid_materials.h"

#include <cstddef>
#include <string>
#include <variant>

#include "base/error.h"
#include "base/names.h"
#include "check/require.h"
#include "materials/material_kind.h"
#include "materials/parameters.h"
#include "scene/material_textures.h"
#include "scene/place.h"

namespace calotype {
namespace {

void requireImage(const ImageTexture& texture, const std::string& where) {
    if (!texture.image)
        throw SceneError(where, "has no image");
    const TexelImage& image = *texture.image;
    constexpr ranges::WholeRange kSide = {1, ImageTexture::kLargestSide};
    require(kSide, image.width, where + "/width");
    require(kSide, image.height, where + "/height");
    const size_t values = image.holdsBytes() ? image.bytes.size() : image.floats.size();
    if (values != 4 * image.texelCount())
        throw SceneError(where, "must hold four values a texel");
}

void requireTexture(const Texture& texture, const std::string& where) {
    for (int i = 0; i < 2; ++i) {
        require(ranges::kTextureCoordinate, texture.scale[i], where + "/scale");
        require(ranges::kTextureCoordinate, texture.offset[i], where + "/offset");
    }
    if (const auto* image = std::get_if<ImageTexture>(&texture.source))
        requireImage(*image, where);
    else
        for (const glm::dvec3& color : std::get<CheckerTexture>(texture.source).colors)
            require(ranges::kShare, color, where + "/colors");
}

/// Checks one parameter of a material at the place of its key.
struct ParameterCheck {
    const Material& material;
    const std::string where;

    void operator()(const NumberParameter& number) const {
        require(number.range, material.*number.number, where);
    }
    void operator()(const ColorParameter& color) const {
        require(color.channel, material.*color.color, where);
    }
    void operator()(const FlagParameter&) const {}
    void operator()(const ChoiceParameter&) const {}
};

void requireTextures(const Scene& scene, const Material& material, const std::string& where) {
    for (uint32_t Material::*slot : kMaterialTextures) {
        const uint32_t texture = material.*slot;
        if (texture != Material::kNoTexture && texture >= scene.textures.size()) {
            throw SceneError(where, "names texture " + std::to_string(texture) + " of " +
                                        std::to_string(scene.textures.size()));
        }
    }
    for (const uint32_t texture : {material.normalMap, material.alphaTexture}) {
        if (texture != Material::kNoTexture &&
            !std::holds_alternative<ImageTexture>(scene.textures[texture].source)) {
            throw SceneError(where, "has a normal map or an alpha texture that is not an image");
        }
    }
}

void requireMaterial(const Scene& scene, size_t index) {
    const Material& material = scene.materials[index];
    const std::string where = placeOfMaterial(scene, index);
    if (static_cast<size_t>(material.type) >= materialKinds().size())
        throw SceneError(where, "has an unknown type");
    const MaterialKind& kind = kindOf(material);
    for (const MaterialParameter& parameter : kind.parameters)
        std::visit(ParameterCheck{material, where + "/" + parameter.name}, parameter.value);
    std::visit(ParameterCheck{material, where + "/emission"}, emissionParameter().value);
    if (!kind.isOpaque && material.emission != glm::dvec3(0.0))
        throw SceneError(where, "a " + kind.name + " cannot emit light");
    require(ranges::kShare, material.opacity, where + "/opacity");
    requireTextures(scene, material, where);
}

} // namespace

void requireValidMaterials(const Scene& scene) {
    for (const Texture& texture : scene.textures)
        requireTexture(texture, placeOf(scene, "texture " + inQuotes(texture.name)));
    for (size_t i = 0; i < scene.materials.size(); ++i)
        requireMaterial(scene, i);
}

} // namespace calotype
