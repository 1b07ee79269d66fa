#include "reference/bsdf.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "reference/blinn_phong_lobe.h"
#include "reference/dielectric_lobe.h"
#include "reference/diffuse_lobe.h"
#include "reference/ggx_lobe.h"
#include "reference/shading_normal.h"
#include "reference/warp.h"
#include "scene/material_textures.h"
#include "scene/texture_lookup.h"

namespace calotype::reference {
namespace {

double scalarAt(double factor, uint32_t texture, const std::vector<Texture>& textures,
                const glm::dvec2& uv) {
    if (texture == Material::kNoTexture)
        return factor;
    return factor * std::clamp(lookUp(textures[texture], uv, false).x, 0.0, 1.0);
}

} // namespace

glm::dvec3 colorAt(const Material& material, const std::vector<Texture>& textures,
                   const glm::dvec2& uv) {
    if (material.colorTexture == Material::kNoTexture)
        return material.color;
    const Texture& texture = textures[material.colorTexture];
    const glm::dvec3 texel = hasCutOutColors(material, textures)
                                 ? lookUpCutOutColor(texture, uv)
                                 : glm::dvec3(lookUp(texture, uv, true));
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

Lobes lobesOfMaterial(const Material& material, const std::vector<Texture>& textures,
                      const glm::dvec2& uv, bool isOutside) {
    Lobes lobes;
    const auto add = [&]<typename Kind>(Kind lobe) {
        lobes.push_back(std::make_unique<Kind>(std::move(lobe)));
    };
    const glm::dvec3 color = colorAt(material, textures, uv);
    const auto scalar = [&](double factor, uint32_t texture) {
        return scalarAt(factor, texture, textures, uv);
    };
    switch (material.type) {
    case MaterialType::Diffuse:
        add(DiffuseLobe(color));
        break;
    case MaterialType::Metal:
        add(GgxLobe(color, scalar(material.roughness, material.roughnessTexture),
                    material.masking));
        break;
    case MaterialType::Nonmetal: {
        const double f0 = scalar(material.specular, material.specularTexture);
        add(DiffuseLobe((1.0 - f0) * color));
        add(GgxLobe(glm::dvec3(f0), scalar(material.roughness, material.roughnessTexture),
                    material.masking));
        break;
    }
    case MaterialType::BlinnPhong:
        add(DiffuseLobe(material.kd * color));
        add(BlinnPhongLobe(material.ks, material.exponent, material.normalize));
        break;
    case MaterialType::Dielectric:
        add(DielectricLobe(color, isOutside ? material.ior / material.exteriorIor
                                            : material.exteriorIor / material.ior));
        break;
    }
    return lobes;
}

Bsdf::Bsdf(const Material& material, const std::vector<Texture>& textures, const Surface& surface,
           const glm::dvec3& wo, LobesOf lobesOf) {
    const bool isOutside = glm::dot(wo, surface.ng) >= 0.0;
    const double side = isOutside ? 1.0 : -1.0;
    ng_ = side * surface.ng;
    horizon_ = side * surface.horizon;
    const glm::dvec3 ns = side * shadingNormal(material, textures, surface);
    worldFromShading_ = frameAbout(consistentNormal(wo, ng_, ns));
    wo_ = wo * worldFromShading_;
    for (std::unique_ptr<Lobe>& lobe : lobesOf(material, textures, surface.uv, isOutside))
        lobes_.push_back({std::move(lobe)});
    shareOut();
}

/// Lobes are chosen by their albedos: kd / (kd + ks), and so on.
void Bsdf::shareOut() {
    double total = 0.0;
    for (WeightedLobe& part : lobes_) {
        part.start = total;
        total += part.lobe->albedo(wo_);
        part.end = total;
    }
    for (WeightedLobe& part : lobes_) {
        part.start = total == 0.0 ? 1.0 : part.start / total;
        part.end = total == 0.0 ? 1.0 : part.end / total;
    }
}

bool Bsdf::isSpecular() const {
    return std::ranges::none_of(lobes_, [](const WeightedLobe& part) {
        return part.chance() > 0.0 && !part.lobe->isSpecular();
    });
}

bool Bsdf::transmits() const {
    return std::ranges::any_of(lobes_,
                               [](const WeightedLobe& part) { return part.lobe->transmits(); });
}

/// Reflected light must leave above the shaded and the true surface, transmitted light below both.
bool Bsdf::isScattered(const glm::dvec3& wi, const glm::dvec3& wiWorld) const {
    if (wo_.z <= 0.0)
        return false;
    return wi.z > 0.0 ? glm::dot(wiWorld, horizon_) > 0.0
                      : wi.z < 0.0 && glm::dot(wiWorld, ng_) < 0.0;
}

Bsdf::Value Bsdf::evaluate(const glm::dvec3& wiWorld) const {
    const glm::dvec3 wi = wiWorld * worldFromShading_;
    if (!isScattered(wi, wiWorld))
        return {};
    glm::dvec3 f(0.0);
    double pdf = 0.0;
    for (const WeightedLobe& part : lobes_) {
        f += part.lobe->f(wo_, wi);
        pdf += part.chance() * part.lobe->pdf(wo_, wi);
    }
    return {f * std::abs(wi.z), pdf};
}

Bsdf::Sample Bsdf::sample(const glm::dvec3& u) const {
    const auto next =
        std::ranges::find_if(lobes_, [&](const WeightedLobe& part) { return u.z < part.start; });
    if (next == lobes_.begin())
        return {};
    const WeightedLobe& chosen = *std::prev(next);
    const double place = (u.z - chosen.start) / chosen.chance();
    const Lobe::Sample scattered = chosen.lobe->sample(wo_, {u.x, u.y, place});
    const glm::dvec3 wi = worldFromShading_ * scattered.wi;
    const bool crosses = scattered.wi.z < 0.0;
    if (scattered.isSpecular)
        return {ontoSideOf(crosses ? -ng_ : ng_, wi), scattered.specularWeight / chosen.chance(),
                std::numeric_limits<double>::infinity(), crosses, scattered.eta};
    const Value mixture = evaluate(wi);
    if (mixture.pdf == 0.0)
        return {};
    return {wi, mixture.value / mixture.pdf, mixture.pdf, crosses, scattered.eta};
}

} // namespace calotype::reference
