#include "read/obj/mtl_material.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/common.hpp>

#include "math/greatest.h"
#include "scene/ranges.h"

namespace calotype {
namespace {

constexpr double kMetallic = 0.5;
constexpr double kMetalRoughness = 0.5;
constexpr double kBlack = 0.05;
constexpr double kBright = 0.5;
constexpr double kGlassIor = 1.5;

class MtlMapping {
public:
    MtlMapping(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps, MtlNotes& notes)
        : mtl_(mtl), name_(name), maps_(maps), notes_(notes),
          illumination_(static_cast<int>(std::clamp(mtl.illumination, -1.0, 11.0))) {}

    Material map() {
        material_.emission = emission();
        readColor();
        readCutOut();
        chooseType();
        if (const auto& map = mtl_.normalMap ? mtl_.normalMap : mtl_.bumpMap)
            material_.normalMap = maps_.normals(*map, mtl_.directory);
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
        if (value < range.low)
            note(std::string(statement) + " was raised to its least value");
        else if (value > range.high)
            note(std::string(statement) + " was lowered to its greatest value");
        return std::clamp(value, range.low, range.high);
    }

    glm::dvec3 atMostOne(const char* statement, const glm::dvec3& color) {
        if (greatest(color) > 1.0)
            note(std::string(statement) + " above 1 was lowered to 1");
        return glm::min(color, glm::dvec3(1.0));
    }

    /// The emission of a material is one radiance: a map is replaced by its mean.
    glm::dvec3 emission() {
        const auto stated = mtl_.emission.value_or(glm::dvec3(mtl_.emissionMap ? 1.0 : 0.0));
        if (!mtl_.emissionMap || stated == glm::dvec3(0.0))
            return stated;
        note("map_Ke shines with its mean colour, since emission cannot be textured yet,");
        const auto mean = maps_.meanColor(*mtl_.emissionMap, mtl_.directory);
        return mean ? stated * *mean : mtl_.emission.value_or(glm::dvec3(0.0));
    }

    void readColor() {
        if (mtl_.diffuseMap)
            material_.colorTexture = maps_.color(*mtl_.diffuseMap, mtl_.directory);
        const bool textured = mtl_.diffuseMap.has_value();
        glm::dvec3 color = mtl_.diffuse.value_or(glm::dvec3(textured ? 1.0 : kUnstatedColor));
        if (textured && color == glm::dvec3(0.0)) {
            note("Kd 0 beside map_Kd, which many exporters write, was taken for 1");
            color = glm::dvec3(1.0);
        }
        material_.color = atMostOne("Kd", color);
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

    bool isIllumination(std::initializer_list<int> models) const {
        return std::ranges::find(models, illumination_) != models.end();
    }

    /// Tinted glass of exporters that write no index; without its filter it would be black.
    bool isBlackFilter() const {
        const bool tints = greatest(mtl_.filter) > 0.0 && mtl_.filter != glm::dvec3(1.0);
        return tints && !mtl_.diffuseMap && greatest(material_.color) <= kBlack;
    }

    /// Glass itself cannot emit light, and a surface with holes is thin.
    bool isGlass() const {
        const bool transmits = mtl_.dissolve.value_or(1.0) < 1.0 ||
                               mtl_.transparency.value_or(0.0) > 0.0 ||
                               mtl_.ior.value_or(1.0) != 1.0 || isBlackFilter();
        return isIllumination({4, 6, 7, 9}) && transmits && material_.emission == glm::dvec3(0.0) &&
               material_.alphaTexture == Material::kNoTexture;
    }

    bool isMirror() const {
        return isIllumination({3, 5}) && !mtl_.diffuseMap && greatest(material_.color) <= kBlack &&
               greatest(mtl_.specular) >= kBright;
    }

    void chooseType() {
        const double exponent = clamped("Ns", mtl_.exponent.value_or(0.0),
                                        closedRange(0.0, Material::kHighestExponent));
        if (mtl_.metallic.value_or(0.0) >= kMetallic) {
            clamped("Pm", *mtl_.metallic, ranges::kShare);
            material_.type = MaterialType::Metal;
            readRoughness(exponent);
        } else if (isGlass()) {
            becomeGlass();
        } else if (isMirror()) {
            material_.type = MaterialType::Metal;
            material_.color = atMostOne("Ks", mtl_.specular);
            material_.roughness = 0.0;
        } else if (mtl_.roughness || mtl_.roughnessMap) {
            material_.type = MaterialType::Nonmetal;
            readRoughness(exponent);
        } else if (greatest(mtl_.specular) > 0.0 && exponent > 0.0 && !isIllumination({0, 1})) {
            becomeGlossy(exponent);
        }
    }

    void becomeGlass() {
        material_.type = MaterialType::Dielectric;
        material_.alphaTexture = Material::kNoTexture;
        material_.color =
            greatest(mtl_.filter) > 0.0 ? atMostOne("Tf", mtl_.filter) : glm::dvec3(1.0);
        material_.ior = mtl_.ior.value_or(1.0);
        if (material_.ior <= 0.0 || material_.ior == 1.0) {
            note("Ni of glass is not given, or 1, or not positive, and was taken for 1.5");
            material_.ior = kGlassIor;
        }
        material_.ior = clamped("Ni", material_.ior, ranges::kIndexOfRefraction);
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
        const double ks = greatest(atMostOne("Ks", mtl_.specular));
        const double share = 1.0 / std::max(1.0, greatest(material_.color) + ks);
        material_.type = MaterialType::BlinnPhong;
        material_.kd = share;
        material_.ks = share * ks;
        material_.exponent = exponent;
        material_.normalize = true;
    }

    const MtlMaterial& mtl_;
    const std::string& name_;
    MtlMaps& maps_;
    MtlNotes& notes_;
    int illumination_;
    Material material_;
};

} // namespace

Material materialFromMtl(const MtlMaterial& mtl, const std::string& name, MtlMaps& maps,
                         MtlNotes& notes) {
    return MtlMapping(mtl, name, maps, notes).map();
}

} // namespace calotype
