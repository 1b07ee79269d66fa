#include "read/obj/mtl_kind.h"

#include <algorithm>

#include "math/greatest.h"

namespace calotype {
namespace {

constexpr double kBlack = 0.05;
constexpr double kBright = 0.5;

} // namespace

MtlKind::MtlKind(const MtlMaterial& mtl)
    : mtl_(mtl),
      illumination_(static_cast<int>(std::clamp(mtl.illumination.value_or(2.0), -1.0, 11.0))) {}

bool MtlKind::isIllumination(std::initializer_list<int> models) const {
    return std::ranges::find(models, illumination_) != models.end();
}

bool MtlKind::isBlack() const {
    return !mtl_.diffuseMap &&
           greatest(mtl_.diffuse.value_or(glm::dvec3(kUnstatedColor))) <= kBlack;
}

/// Tinted glass of exporters that write no index; without its filter it would be black.
bool MtlKind::isTinted() const {
    return greatest(filter()) > 0.0 && filter() != glm::dvec3(1.0) && isBlack();
}

bool MtlKind::isTransmissive() const {
    const bool transmits = mtl_.dissolve.value_or(1.0) < 1.0 ||
                           mtl_.transparency.value_or(0.0) > 0.0 || mtl_.ior.value_or(1.0) != 1.0 ||
                           isTinted();
    return (isIllumination({4, 6, 7, 9}) && transmits) || mtl_.transmission > kTransmissive;
}

bool MtlKind::isMirror() const {
    return isIllumination({3, 5}) && isBlack() &&
           greatest(mtl_.specular.value_or(glm::dvec3(0.0))) >= kBright;
}

glm::dvec3 MtlKind::emission() const {
    return mtl_.emission.value_or(glm::dvec3(mtl_.emissionMap ? 1.0 : 0.0));
}

void MtlKind::visitImages(const VisitImage& visit) const {
    const auto visitIf = [&](bool isUsed, const std::optional<MtlTexture>& map, bool isUploaded) {
        if (isUsed && map)
            visit(*map, isUploaded);
    };
    const bool shines = greatest(emission()) > 0.0;
    const bool isMetal = !mtl_.metallicMap && mtl_.metallic.value_or(0.0) >= kMetallic;
    const bool mayBeGlass = !isMetal && !shines && !mtl_.alphaMap && isTransmissive();
    const bool mayBeSmooth = !isMetal && (mayBeGlass || isMirror());
    const bool isNonmetal =
        !isMetal && !mtl_.metallicMap && !mayBeSmooth && (mtl_.roughness || mtl_.roughnessMap);
    visitIf(true, mtl_.diffuseMap, !mayBeGlass); // of glass it is read for its alpha alone
    visitIf(true, mtl_.alphaMap, true);
    visitIf(true, mtl_.normalMap ? mtl_.normalMap : mtl_.bumpMap, true);
    visitIf(!mayBeSmooth, mtl_.roughnessMap, true);
    visitIf(isNonmetal, mtl_.specularMap, true);
    // Their means alone are used.
    visitIf(true, mtl_.metallicMap, false);
    visitIf(shines, mtl_.emissionMap, false);
}

} // namespace calotype
