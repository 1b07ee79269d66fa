#include "materials/blinn_phong.h"

#include "materials/excess_albedo.h"
#include "materials/parameters.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

/// Weights that sum to one in decimal may not do so in binary.
constexpr double kRounding = 1e-9;

void packBlinnPhong(const Material& material, shared::Material& packed) {
    packed.lobes = shared::kLobeDiffuse | shared::kLobeBlinnPhong |
                   (material.normalize ? shared::kNormalizedLobe : 0);
    packed.specular = static_cast<float>(material.ks);
}

/// Whether the rule of the format, kd + 4 ks > 1, decides, for any colour.
bool isJudgedByWeights(const Material& material) {
    return !material.normalize && material.colorTexture == Material::kNoTexture;
}

/// By the format's rule kd + 4 ks; else kd times the brightest colour, + 4 ks or, if the lobe is
/// normalised, + ks.
std::optional<double> excessOfBlinnPhong(const Material& material, TextureRanges& textures) {
    const double brightest =
        isJudgedByWeights(material) ? 1.0 : brightestChannel(material, textures);
    const double specular = (material.normalize ? 1.0 : 4.0) * material.ks;
    return whereAbove(1.0 + kRounding, material.kd * brightest + specular);
}

std::string warningOfBlinnPhong(const Material& material, double albedo) {
    return "this blinn_phong can reflect " +
           (isJudgedByWeights(material)
                ? "more light than it receives, since kd + 4 ks > 1"
                : "up to " + albedoText(albedo) + " of the light that it receives") +
           "; lower kd or ks" + (material.normalize ? "" : ", or set \"normalize\": true");
}

} // namespace

MaterialKind blinnPhongKind() {
    return {"blinn_phong",
            "A half-vector Blinn-Phong lobe over a diffuse one. A warning says where the two can "
            "reflect more light than they receive.",
            {texturedColor("The colour of the diffuse lobe."),
             {"kd", NumberParameter{&Material::kd, nullptr, ranges::kShare}, std::nullopt,
              "The weight of the diffuse lobe."},
             {"ks", NumberParameter{&Material::ks, nullptr, ranges::kShare}, std::nullopt,
              "The weight of the specular lobe, which reflects up to 4 ks, or ks with normalize."},
             {"exponent",
              NumberParameter{&Material::exponent, nullptr,
                              closedRange(0.0, Material::kHighestExponent)},
              std::nullopt, "The power of the cosine to the half vector: greater is sharper."},
             {"normalize", FlagParameter{&Material::normalize}, 0.0,
              "Selects a form that conserves energy."}},
            true,
            packBlinnPhong,
            excessOfBlinnPhong,
            warningOfBlinnPhong};
}

} // namespace calotype
