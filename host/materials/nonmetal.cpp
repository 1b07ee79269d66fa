#include "materials/nonmetal.h"

#include <algorithm>
#include <set>

#include "materials/excess_albedo.h"
#include "materials/ggx.h"
#include "materials/parameters.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

/// An albedo must exceed one by more than this: the error of its integration.
constexpr double kTolerance = 0.002;
constexpr int kAngles = 20; ///< from a cosine of 1 / 20 (87 degrees) to 1

void packNonmetal(const Material& material, shared::Material& packed) {
    packed.lobes = ggxLobe(material) | shared::kLobeDiffuse;
}

/// By numerical integration up to an angle of 87 degrees. There, with Masking::Schlick and an F0 of
/// 0.04, colours from 0.88 (roughness 0) to 0.99 (roughness 0.8) exceed 1. Uses the least F0: the
/// albedo is linear in F0 and at most one at F0 = 1, so if it exceeds one at all, it decreases as
/// F0 grows.
std::optional<double> excessOfNonmetal(const Material& material, TextureRanges& textures) {
    const double f0 = material.specular * textures.scalars(material.specularTexture).least;
    const double diffuse = (1.0 - f0) * brightestChannel(material, textures);
    const ScalarRange share = textures.scalars(material.roughnessTexture);
    double most = 0.0;
    for (const double end : std::set{share.least, share.greatest}) {
        const double roughness = material.roughness * end;
        for (int i = 1; i <= kAngles; ++i) {
            most = std::max(
                most, diffuse + ggxAlbedo(double(i) / kAngles, roughness, f0, material.masking));
        }
    }
    return whereAbove(1.0 + kTolerance, most);
}

std::string warningOfNonmetal(const Material& material, double albedo) {
    const bool isTextured = material.colorTexture != Material::kNoTexture ||
                            material.roughnessTexture != Material::kNoTexture ||
                            material.specularTexture != Material::kNoTexture;
    return std::string("this nonmetal ") + (isTextured ? "can reflect" : "reflects") + " up to " +
           albedoText(albedo) +
           " of the light that it receives, at grazing angles; choose a darker colour";
}

} // namespace

MaterialKind nonmetalKind() {
    return {
        "nonmetal",
        "A GGX lobe over a diffuse one. Near-white colours reflect more light than they receive "
        "at grazing angles; a warning says so.",
        {texturedColor("The share of light that the diffuse lobe reflects."),
         roughnessParameter(),
         {"specular",
          NumberParameter{&Material::specular, &Material::specularTexture, ranges::kShare},
          Material().specular, "F0, the share that the GGX lobe reflects at normal incidence."},
         maskingParameter()},
        true,
        packNonmetal,
        excessOfNonmetal,
        warningOfNonmetal};
}

} // namespace calotype
