#include "scene/energy_warnings.h"

#include <iomanip>
#include <sstream>

#include "base/names.h"
#include "scene/borne_materials.h"
#include "scene/material_energy.h"

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

/// One sentence for all materials of an OBJ's MTL files. Of those only nonmetals reflect too much.
void warnOfMtl(const std::string& objPath, const std::vector<bool>& borne, TextureRanges& textures,
               LoadContext& context) {
    const std::vector<std::string>& names = context.objFiles.at(objPath)->materialNames;
    const std::vector<uint32_t>& materials = context.mtlMaterials.at(objPath);
    std::vector<std::string> excessive;
    double most = 0.0;
    for (size_t i = 0; i < names.size(); ++i) {
        const Material& material = context.scene.materials[materials[i]];
        const auto albedo = borne[materials[i]] ? excessAlbedo(material, textures) : std::nullopt;
        if (albedo) {
            excessive.push_back(names[i]);
            most = std::max(most, *albedo);
        }
    }
    if (!excessive.empty()) {
        context.warn(objPath, "materials that can reflect more light than they receive, up to " +
                                  percent(most) + " at grazing angles (lower Kd or raise Pr): " +
                                  listInQuotes(excessive));
    }
}

} // namespace

void warnOfExcessEnergy(LoadContext& context) {
    const std::vector<bool> borne = borneMaterials(context.scene);
    TextureRanges textures(context.scene.textures);
    for (size_t i = 0; i < context.materialPlaces.size(); ++i) {
        const Material& material = context.scene.materials[i];
        const auto albedo = borne[i] ? excessAlbedo(material, textures) : std::nullopt;
        if (albedo) {
            context.warn(context.materialPlaces[i], energyWarning(material, *albedo));
        }
    }
    for (const auto& [objPath, unused] : context.mtlMaterials) {
        warnOfMtl(objPath, borne, textures, context);
    }
}

} // namespace calotype
