#include "check/texture_precision.h"

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <glm/common.hpp>

#include "base/names.h"
#include "scene/material_textures.h"
#include "scene/place.h"

namespace calotype {
namespace {

/// The lookup of a texture that is farthest from the origin of its coordinates.
struct FarthestLookup {
    double texels = 0.0;
    size_t shape = 0;
};

/// The number of texels from a texture's origin to lookups at coordinates up to `farthestUv`.
double texelsTo(const Texture& texture, const glm::dvec2& farthestUv) {
    glm::dvec2 size(1.0);
    if (const auto* image = std::get_if<ImageTexture>(&texture.source))
        size = {image->image->width, image->image->height};
    const glm::dvec2 position = farthestUv * glm::abs(texture.scale) + glm::abs(texture.offset);
    return std::max(position.x * size.x, position.y * size.y);
}

class TextureReach {
public:
    explicit TextureReach(const Scene& scene) : scene_(scene), farthest_(scene.textures.size()) {
        for (size_t i = 0; i < scene.shapes.size(); ++i)
            if (const auto* mesh = std::get_if<Mesh>(&scene.shapes[i].geometry))
                addMesh(*mesh, i);
            else
                add(scene.shapes[i].material, glm::dvec2(1.0), i);
    }

    const std::vector<FarthestLookup>& farthest() const { return farthest_; } ///< by texture

private:
    void addMesh(const Mesh& mesh, size_t shape) {
        std::map<uint32_t, glm::dvec2> farthestUv; // by material
        for (const Mesh::Triangle& triangle : mesh.triangles) {
            if (triangle.uv[0] == Mesh::kNoUv || !hasTextures(scene_.materials[triangle.material]))
                continue;
            glm::dvec2& uv = farthestUv[triangle.material];
            for (const uint32_t corner : triangle.uv)
                uv = glm::max(uv, glm::abs(mesh.uvs[corner]));
        }
        for (const auto& [material, uv] : farthestUv)
            add(material, uv, shape);
    }

    void add(uint32_t material, const glm::dvec2& farthestUv, size_t shape) {
        for (uint32_t Material::*slot : kMaterialTextures) {
            const uint32_t texture = scene_.materials[material].*slot;
            if (texture == Material::kNoTexture)
                continue;
            const double texels = texelsTo(scene_.textures[texture], farthestUv);
            if (texels > farthest_[texture].texels)
                farthest_[texture] = {texels, shape};
        }
    }

    const Scene& scene_;
    std::vector<FarthestLookup> farthest_;
};

} // namespace

void warnOfTexturePrecision(const Scene& scene, Warnings& warnings) {
    struct Excess {
        double texels = 0.0;
        std::vector<std::string> names;
    };
    const std::vector<FarthestLookup> farthest = TextureReach(scene).farthest();
    std::map<size_t, Excess> excesses; // by shape
    for (size_t i = 0; i < farthest.size(); ++i) {
        if (farthest[i].texels > kFarthestTexel) {
            Excess& excess = excesses[farthest[i].shape];
            excess.texels = std::max(excess.texels, farthest[i].texels);
            excess.names.push_back(scene.textures[i].name);
        }
    }
    for (const auto& [shape, excess] : excesses) {
        warnings.add(placeOfShape(scene, shape),
                     "textures are read up to " + twoDigits(excess.texels) +
                         " texels from their origin, where single precision is off by up to " +
                         twoDigits(0.5 * excess.texels / kFarthestTexel) +
                         " of them (take whole numbers off the texture coordinates, or repeat the "
                         "textures less): " +
                         listInQuotes(excess.names),
                     "textures read too far from their origin");
    }
}

} // namespace calotype
