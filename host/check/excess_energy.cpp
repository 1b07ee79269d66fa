#include "check/excess_energy.h"

#include <algorithm>
#include <cstdint>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "base/names.h"
#include "materials/material_energy.h"
#include "scene/used_materials.h"

namespace calotype {
namespace {

std::string percent(double share) {
    std::ostringstream text;
    text << std::fixed << std::setprecision(1) << 100.0 * share << " %";
    return text.str();
}

std::string blinnPhongWarning(const Material& blinnPhong, const std::string& share) {
    return "this blinn_phong can reflect " +
           (isJudgedByWeights(blinnPhong) ? "more light than it receives, since kd + 4 ks > 1"
                                          : "up to " + share + " of the light that it receives") +
           "; lower kd or ks" + (blinnPhong.normalize ? "" : ", or set \"normalize\": true");
}

std::string energyWarning(const Material& material, double albedo) {
    const std::string share = percent(albedo);
    if (material.type == MaterialType::BlinnPhong) {
        return blinnPhongWarning(material, share);
    }
    const uint32_t slots[] = {material.colorTexture, material.roughnessTexture,
                              material.specularTexture};
    const bool textured = std::ranges::any_of(
        slots, [](uint32_t texture) { return texture != Material::kNoTexture; });
    return std::string("this nonmetal ") + (textured ? "can reflect" : "reflects") + " up to " +
           share + " of the light that it receives, at grazing angles; choose a darker colour";
}

/// Materials that come from one place, such as an OBJ's MTL files, and reflect too much.
struct Excess {
    std::vector<uint32_t> materials; ///< indices into Scene::materials
    double most = 0.0;               ///< the largest share of light that one of them reflects
};

std::string energyWarning(const Scene& scene, const Excess& excess) {
    std::vector<std::string> names;
    for (const uint32_t i : excess.materials) {
        names.push_back(scene.materials[i].name);
    }
    return "materials that can reflect more light than they receive, up to " +
           percent(excess.most) +
           " at grazing angles (choose darker colours or a greater roughness): " +
           listInQuotes(names);
}

} // namespace

void warnOfExcessEnergy(const Scene& scene, Warnings& warnings) {
    const std::vector<bool> used = usedMaterials(scene);
    TextureRanges textures(scene.textures);
    std::map<std::string, size_t> materialsOfPlace;
    std::map<std::string, Excess> excessOfPlace;
    for (uint32_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        ++materialsOfPlace[material.place];
        if (const auto albedo = used[i] ? excessAlbedo(material, textures) : std::nullopt) {
            Excess& excess = excessOfPlace[material.place];
            excess.materials.push_back(i);
            excess.most = std::max(excess.most, *albedo);
        }
    }
    for (const auto& [place, excess] : excessOfPlace) {
        warnings.add(place,
                     materialsOfPlace[place] > 1
                         ? energyWarning(scene, excess)
                         : energyWarning(scene.materials[excess.materials.front()], excess.most));
    }
}

} // namespace calotype
