#include "read/obj/mtl_blender.h"

#include <cmath>
#include <optional>
#include <utility>

namespace calotype {
namespace {

constexpr double kHighestExponent = 1000.0;
constexpr double kUsualExponent = 250.0; ///< of a roughness of 0.5

double meanOf(const glm::dvec3& color) { return (color.x + color.y + color.z) / 3.0; }

bool isGrey(const std::optional<glm::dvec3>& color) {
    return !color || (color->x == color->y && color->y == color->z);
}

bool hasPbrOption(const MtlMaterial& mtl) {
    return mtl.roughness || mtl.roughnessMap || mtl.metallic || mtl.metallicMap;
}

/// Ns is 1000 (1 - roughness)^2; the texels of map_Ns are roughnesses, beside which it says
/// nothing.
void readRoughness(MtlMaterial& mtl, const std::string& name, MtlNotes& notes) {
    mtl.roughnessMap = std::exchange(mtl.exponentMap, std::nullopt);
    const std::optional<double> stated = std::exchange(mtl.exponent, std::nullopt);
    if (mtl.roughnessMap)
        return;
    const double exponent = notes.clamped("Ns", stated.value_or(kUsualExponent),
                                          closedRange(0.0, kHighestExponent), name);
    mtl.roughness = 1.0 - std::sqrt(exponent / kHighestExponent);
}

/// Ka is the metallic share under these models; elsewhere it is 1 and means nothing.
void readMetallic(MtlMaterial& mtl, double model) {
    mtl.metallicMap = std::exchange(mtl.reflectionMap, std::nullopt);
    if (!mtl.metallicMap && (model == 3.0 || model == 6.0))
        mtl.metallic = meanOf(mtl.ambient.value_or(glm::dvec3(0.0)));
}

} // namespace

MtlMaterial inBlendersMeaning(MtlMaterial mtl, const std::string& name, MtlNotes& notes) {
    const double model = mtl.illumination.value_or(2.0);
    if (hasPbrOption(mtl)) {
        mtl.transmission = meanOf(mtl.filter.value_or(glm::dvec3(0.0)));
        mtl.filter.reset();
    } else if (isGrey(mtl.ambient) && isGrey(mtl.specular)) {
        readRoughness(mtl, name, notes);
        readMetallic(mtl, model);
        if (model == 0.0 || model == 1.0)
            mtl.specular = glm::dvec3(0.0);
    } else if (mtl.exponentMap || mtl.specularMap || mtl.reflectionMap) {
        notes.add("map_Ns, map_Ks and map_refl were ignored, because Ks or Ka is not grey,", name);
    }
    // 3 and 6 mark metals, 6 and 9 opacity; none of them marks mirrors or glass.
    if (!mtl.filter && (model == 3.0 || model == 6.0 || model == 9.0))
        mtl.illumination = 2.0;
    return mtl;
}

} // namespace calotype
