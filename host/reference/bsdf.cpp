#include "reference/bsdf.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/shading_normal.h"
#include "reference/warp.h"
#include "scene/texture_lookup.h"

namespace calotype::reference {
namespace {

double greatest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

double scalarAt(double factor, uint32_t texture, const std::vector<Texture>& textures,
                const glm::dvec2& uv) {
    if (texture == Material::kNoTexture)
        return factor;
    return factor * std::clamp(lookUp(textures[texture], uv, false).x, 0.0, 1.0);
}

/// Lobes are chosen by what they reflect: kd / (kd + ks), and the like.
double probabilityOfDiffuse(const glm::dvec3& diffuse, const glm::dvec3& specular) {
    const double d = greatest(diffuse);
    const double s = greatest(specular);
    return d + s > 0.0 ? d / (d + s) : 1.0;
}

} // namespace

glm::dvec3 colorAt(const Material& material, const std::vector<Texture>& textures,
                   const glm::dvec2& uv) {
    if (material.colorTexture == Material::kNoTexture)
        return material.color;
    const glm::dvec3 texel(lookUp(textures[material.colorTexture], uv, true));
    return material.color * glm::clamp(texel, 0.0, 1.0);
}

double alphaAt(const Material& material, const std::vector<Texture>& textures,
               const glm::dvec2& uv) {
    if (material.alphaTexture == Material::kNoTexture)
        return material.opacity;
    return material.opacity * lookUp(textures[material.alphaTexture], uv, false).w;
}

glm::dvec3 shadingNormal(const Material& material, const std::vector<Texture>& textures,
                         const Surface& surface) {
    if (material.normalMap == Material::kNoTexture)
        return surface.ns;
    const glm::dvec3 texel(lookUp(textures[material.normalMap], surface.uv, false));
    return mappedNormal(texel, surface.ns, surface.dpdu, surface.dpdv, surface.ng);
}

Bsdf::Bsdf(const Material& material, const std::vector<Texture>& textures, const Surface& surface,
           const glm::dvec3& wo) {
    const bool isOutside = glm::dot(wo, surface.ng) >= 0.0;
    const double side = isOutside ? 1.0 : -1.0;
    ng_ = side * surface.ng;
    horizon_ = side * surface.horizon;
    const glm::dvec3 ns = side * shadingNormal(material, textures, surface);
    worldFromShading_ = frameAbout(consistentNormal(wo, ng_, ns));
    wo_ = wo * worldFromShading_;

    const glm::dvec3 color = colorAt(material, textures, surface.uv);
    const auto scalar = [&](double factor, uint32_t texture) {
        return scalarAt(factor, texture, textures, surface.uv);
    };
    switch (material.type) {
    case MaterialType::Diffuse:
        diffuse_ = color;
        break;
    case MaterialType::Metal:
        hasGgx_ = true;
        ggx_ = {color, scalar(material.roughness, material.roughnessTexture), material.masking};
        diffuseProbability_ = probabilityOfDiffuse(glm::dvec3(0.0), fresnelSchlick(ggx_.f0, wo_.z));
        break;
    case MaterialType::Nonmetal: {
        hasGgx_ = true;
        const double f0 = scalar(material.specular, material.specularTexture);
        ggx_ = {glm::dvec3(f0), scalar(material.roughness, material.roughnessTexture),
                material.masking};
        diffuse_ = (1.0 - f0) * color;
        diffuseProbability_ = probabilityOfDiffuse(diffuse_, fresnelSchlick(ggx_.f0, wo_.z));
        break;
    }
    case MaterialType::BlinnPhong:
        hasBlinnPhong_ = true;
        blinnPhong_ = {material.ks, material.exponent, material.normalize};
        diffuse_ = material.kd * color;
        diffuseProbability_ = probabilityOfDiffuse(diffuse_, glm::dvec3(material.ks));
        break;
    case MaterialType::Dielectric:
        isDielectric_ = true;
        tint_ = color;
        eta_ =
            isOutside ? material.ior / material.exteriorIor : material.exteriorIor / material.ior;
        break;
    }
}

bool Bsdf::isSpecular() const {
    return isDielectric_ || (isMirror() && diffuseProbability_ == 0.0);
}

Bsdf::Value Bsdf::evaluate(const glm::dvec3& wiWorld) const {
    const glm::dvec3 wi = wiWorld * worldFromShading_;
    if (isDielectric_ || wo_.z <= 0.0 || wi.z <= 0.0 || glm::dot(wiWorld, horizon_) <= 0.0)
        return {};
    glm::dvec3 f = diffuse_ / kPi;
    double pdf = diffuseProbability_ * wi.z / kPi;
    if (hasGgx_ && !isMirror()) {
        f += ggx_.f(wo_, wi);
        pdf += (1.0 - diffuseProbability_) * ggx_.pdf(wo_, wi);
    }
    if (hasBlinnPhong_) {
        f += blinnPhong_.f(wo_, wi);
        pdf += (1.0 - diffuseProbability_) * blinnPhong_.pdf(wo_, wi);
    }
    return {f * wi.z, pdf};
}

Bsdf::Sample Bsdf::sampleDielectric(double u) const {
    const Boundary boundary = boundaryAt(wo_.z, eta_);
    constexpr double kCertain = std::numeric_limits<double>::infinity();
    if (u < boundary.reflectance)
        return {ontoSideOf(ng_, toWorld({-wo_.x, -wo_.y, wo_.z})), glm::dvec3(1.0), kCertain,
                false};
    const glm::dvec3 refracted(-wo_.x / eta_, -wo_.y / eta_, -boundary.cosThetaT);
    // Radiance beyond the boundary is spread over another solid angle.
    return {ontoSideOf(-ng_, toWorld(refracted)), tint_ / (eta_ * eta_), kCertain, true};
}

Bsdf::Sample Bsdf::sample(const glm::dvec3& u) const {
    if (isDielectric_)
        return sampleDielectric(u.z);
    const glm::dvec2 uLobe(u.x, u.y);
    glm::dvec3 wi;
    if (u.z < diffuseProbability_) {
        wi = warpToCosineHemisphere(uLobe);
    } else if (isMirror()) {
        const glm::dvec3 mirrored = toWorld({-wo_.x, -wo_.y, wo_.z});
        return {ontoSideOf(ng_, mirrored), ggx_.mirrorWeight(wo_.z) / (1.0 - diffuseProbability_),
                std::numeric_limits<double>::infinity(), false};
    } else {
        const glm::dvec3 h =
            hasGgx_ ? ggx_.sampleHalfVector(wo_, uLobe) : blinnPhong_.sampleHalfVector(uLobe);
        wi = glm::reflect(-wo_, h);
    }
    const glm::dvec3 wiWorld = toWorld(wi);
    const Value mixture = evaluate(wiWorld);
    if (mixture.pdf <= 0.0)
        return {};
    return {wiWorld, mixture.value / mixture.pdf, mixture.pdf, false};
}

} // namespace calotype::reference
