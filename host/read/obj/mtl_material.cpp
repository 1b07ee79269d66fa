#include "read/obj/mtl_material.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "base/number_text.h"
#include "math/greatest.h"
#include "math/square.h"
#include "read/obj/mtl_blender.h"
#include "read/obj/mtl_kind.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

constexpr double kMetalRoughness = 0.5;
constexpr double kGlassIor = 1.5;
constexpr double kUsualLevel = 0.5; ///< of specular light: its F0 is that of the index

class MtlMapping {
public:
    MtlMapping(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps, MtlNotes& notes)
        : mtl_(mtl), name_(name), maps_(maps), notes_(notes), kind_(mtl) {}

    Material map() {
        specular_ = specular();
        readColor();
        readCutOut();
        material_.emission = emission();
        chooseType();
        readNormals();
        if (material_.type == MaterialType::Dielectric)
            leaveOutColorTexture();
        else
            material_.opacity = opacity();
        return material_;
    }

private:
    void leaveOutColorTexture() {
        if (material_.colorTexture != Material::kNoTexture) {
            note("map_Kd of glass was ignored");
            material_.colorTexture = Material::kNoTexture;
        }
    }

    void note(const std::string& remark) { notes_.add(remark, name_); }

    double clamped(const char* statement, double value, const Range& range) {
        return notes_.clamped(statement, value, range, name_);
    }

    glm::dvec3 share(const char* statement, const glm::dvec3& color) {
        if (greatest(color) > 1.0)
            note(std::string(statement) + " above 1 was lowered to 1");
        if (greatest(-color) > 0.0)
            note(std::string(statement) + " below 0 was raised to 0");
        return glm::clamp(color, 0.0, 1.0);
    }

    glm::dvec3 specular() {
        const glm::dvec3 stated = mtl_.specular.value_or(glm::dvec3(0.0));
        if (greatest(-stated) > 0.0)
            note("Ks below 0 was raised to 0");
        return glm::max(stated, glm::dvec3(0.0));
    }

    /// Radiances so small that no picture shows them are 0.
    glm::dvec3 radiance(const glm::dvec3& stated) {
        if (greatest(-stated) > 0.0)
            note("Ke below 0 was raised to 0");
        if (greatest(stated) > ranges::kEmitter.high)
            note("Ke above " + shortNumber(ranges::kEmitter.high) + " was lowered to " +
                 shortNumber(ranges::kEmitter.high));
        const glm::dvec3 clamped = glm::clamp(stated, 0.0, ranges::kEmitter.high);
        if (greatest(clamped) >= ranges::kEmitter.low || clamped == glm::dvec3(0.0))
            return clamped;
        note("Ke, which is too small for any picture, was lowered to 0");
        return glm::dvec3(0.0);
    }

    /// The emission of a material is one radiance: a map is replaced by its mean. Where the
    /// material has holes, the colour of a transparent texel has no meaning (see hasCutOutColors).
    glm::dvec3 emission() {
        const glm::dvec3 stated = kind_.emission();
        if (!mtl_.emissionMap || greatest(stated) <= 0.0)
            return radiance(stated);
        note("the mean colour of map_Ke is used for emission, which cannot be textured,");
        const bool hasHoles = material_.alphaTexture != Material::kNoTexture;
        const auto mean = maps_.meanColor(*mtl_.emissionMap, mtl_.directory,
                                          hasHoles ? AlphaWeights::Yes : AlphaWeights::No);
        return radiance(mean ? stated * *mean : mtl_.emission.value_or(glm::dvec3(0.0)));
    }

    void readColor() {
        if (mtl_.diffuseMap)
            material_.colorTexture = maps_.color(*mtl_.diffuseMap, mtl_.directory);
        const bool textured = mtl_.diffuseMap.has_value();
        glm::dvec3 color = mtl_.diffuse.value_or(glm::dvec3(textured ? 1.0 : kUnstatedColor));
        if (textured && greatest(color) <= 0.0) {
            note("Kd 0 beside map_Kd, which many exporters write, was taken for 1");
            color = glm::dvec3(1.0);
        }
        material_.color = share("Kd", color);
    }

    void readNormals() {
        if (mtl_.normalMap) {
            material_.normalMap = maps_.normals(*mtl_.normalMap, mtl_.directory);
        } else if (mtl_.bumpMap) {
            const BumpKind kind = maps_.bumpKind(*mtl_.bumpMap, mtl_.directory);
            if (kind == BumpKind::ColoredHeights) {
                note("a coloured picture of bump, which does not look like a normal map, was read "
                     "as heights");
            }
            material_.normalMap = kind == BumpKind::Normals
                                      ? maps_.normals(*mtl_.bumpMap, mtl_.directory)
                                      : maps_.heights(*mtl_.bumpMap, mtl_.directory);
        }
    }

    void readCutOut() {
        if (mtl_.alphaMap)
            material_.alphaTexture = maps_.alpha(*mtl_.alphaMap, mtl_.directory);
        else if (mtl_.diffuseMap && maps_.isTransparent(material_.colorTexture))
            material_.alphaTexture = material_.colorTexture;
    }

    double opacity() {
        if (mtl_.dissolve)
            return clamped("d", *mtl_.dissolve, ranges::kShare);
        if (mtl_.transparency == 1.0) {
            note("Tr 1 without d, which would be invisible and is often written for opaque, was "
                 "taken for opaque");
            return 1.0;
        }
        return 1.0 - clamped("Tr", mtl_.transparency.value_or(0.0), ranges::kShare);
    }

    /// Glass itself cannot emit light, and a surface with holes is thin.
    bool isGlass() const {
        return kind_.isTransmissive() && material_.emission == glm::dvec3(0.0) &&
               material_.alphaTexture == Material::kNoTexture;
    }

    /// The metallic share cannot be textured: a map is replaced by its mean.
    double metallic() {
        const double stated = clamped("Pm", mtl_.metallic.value_or(0.0), ranges::kShare);
        const auto mean = mtl_.metallicMap ? maps_.mean(*mtl_.metallicMap, mtl_.directory)
                                           : std::optional<double>();
        if (mean) {
            note("a map of the metallic share was replaced by its mean, since it cannot be "
                 "textured,");
            return mtl_.metallic ? stated * *mean : *mean;
        }
        if (stated > 0.0 && stated < 1.0)
            note("a metallic share between 0 and 1 was rounded to the nearer one");
        return stated;
    }

    void chooseType() {
        const double exponent = clamped("Ns", mtl_.exponent.value_or(0.0),
                                        closedRange(0.0, Material::kHighestExponent));
        if (metallic() >= kMetallic) {
            becomeMetal();
            readRoughness(exponent);
        } else if (isGlass()) {
            becomeGlass();
        } else if (kind_.isMirror()) {
            becomeMetal();
            material_.color = share("Ks", specular_);
            material_.roughness = 0.0;
        } else if (mtl_.roughness || mtl_.roughnessMap) {
            becomeNonmetal();
            readRoughness(exponent);
        } else if (greatest(specular_) > 0.0 && exponent > 0.0 && !kind_.isIllumination({0, 1})) {
            becomeGlossy(exponent);
        }
        if (mtl_.transmission > 0.0 && material_.type != MaterialType::Metal &&
            material_.type != MaterialType::Dielectric) {
            note("transmission (Tf) of at most 0.5, or of a surface that shines or has holes, was "
                 "ignored");
        }
    }

    /// The exact masking: with the other one a mirror loses 13 % of the light.
    void becomeMetal() {
        material_.type = MaterialType::Metal;
        material_.masking = Masking::Smith;
    }

    void becomeGlass() {
        material_.type = MaterialType::Dielectric;
        material_.alphaTexture = Material::kNoTexture;
        if (mtl_.transmission > kTransmissive) {
            // Light crosses glass twice, and Kd is the colour behind both.
            material_.color = glm::sqrt(material_.color);
            if (mtl_.roughness.value_or(0.0) > 0.0 || mtl_.roughnessMap)
                note("the roughness of glass was ignored");
            if (mtl_.dissolve.value_or(1.0) < 1.0)
                note("d of glass was ignored");
        } else {
            material_.color =
                greatest(kind_.filter()) > 0.0 ? share("Tf", kind_.filter()) : glm::dvec3(1.0);
        }
        material_.ior = indexOfGlass();
    }

    /// Ni, or 1.5 for numbers that mean nothing.
    double indexOfGlass() {
        const double index = mtl_.ior.value_or(0.0);
        if (index > 0.0 && (index != 1.0 || mtl_.transmission > 0.0))
            return clamped("Ni", index, ranges::kIndexOfRefraction);
        note("Ni of glass is not given, or 1, or not positive, and was taken for 1.5");
        return kGlassIor;
    }

    /// Ks is the specular level.
    void becomeNonmetal() {
        material_.type = MaterialType::Nonmetal;
        if (mtl_.isFromBlender)
            material_.masking = Masking::Smith;
        if (!mtl_.specular && !mtl_.specularMap && !mtl_.isFromBlender)
            return;
        const double written = mtl_.ior.value_or(kGlassIor);
        const double index =
            clamped("Ni", written > 0.0 ? written : kGlassIor, ranges::kIndexOfRefraction);
        if (mtl_.specularMap)
            material_.specularTexture = maps_.scalar(*mtl_.specularMap, mtl_.directory);
        const bool isMapped = material_.specularTexture != Material::kNoTexture;
        const glm::dvec3 stated = mtl_.specular ? specular_ : glm::dvec3(kUsualLevel);
        const double level = isMapped ? 1.0 : greatest(share("Ks", stated));
        material_.specular = std::min(1.0, 2.0 * level * square((index - 1.0) / (index + 1.0)));
        if (material_.specular == 0.0)
            material_.type = MaterialType::Diffuse; // the index is that of air: no grazing light
    }

    void readRoughness(double exponent) {
        if (mtl_.roughnessMap)
            material_.roughnessTexture = maps_.scalar(*mtl_.roughnessMap, mtl_.directory);
        if (mtl_.roughness) {
            material_.roughness = clamped("Pr", *mtl_.roughness, ranges::kShare);
        } else if (material_.roughnessTexture != Material::kNoTexture) {
            material_.roughness = 1.0;
        } else if (exponent > 0.0) {
            // A lobe of exponent n has about the width of a GGX lobe of alpha = sqrt(2 / (n + 2)).
            material_.roughness = std::pow(2.0 / (exponent + 2.0), 0.25);
        } else {
            material_.roughness = kMetalRoughness;
        }
    }

    /// Old files combine Ks 1 with a bright Kd: both keep their proportion, but together they
    /// reflect no more than they receive.
    void becomeGlossy(double exponent) {
        const double ks = greatest(share("Ks", specular_));
        const double scale = 1.0 / std::max(1.0, greatest(material_.color) + ks);
        material_.type = MaterialType::BlinnPhong;
        material_.kd = scale;
        material_.ks = scale * ks;
        material_.exponent = exponent;
        material_.normalize = true;
    }

    const MtlMaterial& mtl_;
    const std::string& name_;
    MtlMaps& maps_;
    MtlNotes& notes_;
    MtlKind kind_;
    glm::dvec3 specular_{0.0};
    Material material_;
};

} // namespace

Material materialFromMtl(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps,
                         MtlNotes& notes) {
    if (mtl.isFromBlender)
        return MtlMapping(inBlendersMeaning(mtl, name, notes), name, maps, notes).map();
    return MtlMapping(mtl, name, maps, notes).map();
}

void visitImagesOf(const MtlMaterial& mtl, const MtlKind::VisitImage& visit) {
    MtlNotes unused;
    MtlKind(mtl.isFromBlender ? inBlendersMeaning(mtl, "", unused) : mtl).visitImages(visit);
}

} // namespace calotype
