#include "check/excess_energy.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "base/names.h"
#include "materials/excess_albedo.h"
#include "materials/material_kind.h"
#include "scene/place.h"
#include "scene/used_materials.h"

namespace calotype {
namespace {

/// Materials with the same place, such as an OBJ's MTL files, that reflect too much.
struct Excess {
    std::vector<uint32_t> materials; ///< indices into Scene::materials
    double most = 0.0;               ///< the largest share of light that one of them reflects
};

std::string energyWarning(const Scene& scene, const Excess& excess) {
    std::vector<std::string> names;
    for (const uint32_t i : excess.materials)
        names.push_back(scene.materials[i].name);
    return "materials that can reflect more light than they receive, up to " +
           albedoText(excess.most) +
           " at grazing angles (choose darker colours or a greater roughness): " +
           listInQuotes(names);
}

std::string energyWarning(const Material& material, double albedo) {
    return kindOf(material).excessWarning(material, albedo);
}

} // namespace

void warnOfExcessEnergy(const Scene& scene, Warnings& warnings) {
    const std::vector<bool> used = usedMaterials(scene);
    TextureRanges textures(scene.textures);
    std::map<std::string, size_t> materialsOfPlace;
    std::map<std::string, Excess> excessOfPlace;
    for (uint32_t i = 0; i < scene.materials.size(); ++i) {
        const Material& material = scene.materials[i];
        const std::string place = placeOfMaterial(scene, i);
        ++materialsOfPlace[place];
        if (const auto albedo = used[i] ? excessAlbedo(material, textures) : std::nullopt) {
            Excess& excess = excessOfPlace[place];
            excess.materials.push_back(i);
            excess.most = std::max(excess.most, *albedo);
        }
    }
    for (const auto& [place, excess] : excessOfPlace) {
        const Material& first = scene.materials[excess.materials.front()];
        if (materialsOfPlace[place] > 1)
            warnings.add(place, energyWarning(scene, excess), "materials that reflect too much");
        else
            warnings.add(place, energyWarning(first, excess.most),
                         "reflects too much: " + kindOf(first).name);
    }
}

} // namespace calotype
