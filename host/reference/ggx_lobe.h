#pragma once

#include <glm/vec2.hpp>

#include "reference/lobe.h"
#include "scene/scene.h"

namespace calotype::reference {

/// Schlick's approximation of Fresnel's equations (docs/models.md, "Fresnel, Schlick").
glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double cosTheta);

/// Reflection by GGX microfacets, with Schlick's or Smith's masking (docs/models.md, "GGX" and "GGX
/// masking"). Below kMirrorAlpha a mirror ("Mirror").
class GgxLobe final : public Lobe {
public:
    /// No unit: the tangent of a lobe's half width.
    static constexpr double kMirrorAlpha = 1e-4;

    GgxLobe(const glm::dvec3& f0, double roughness, Masking masking)
        : f0_(f0), roughness_(roughness), masking_(masking) {}

    bool isSpecular() const override { return alpha() < kMirrorAlpha; }
    double albedo(const glm::dvec3& wo) const override;
    glm::dvec3 f(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override;

private:
    double alpha() const { return roughness_ * roughness_; }
    double d(double cosThetaH) const;
    double g1(double cosTheta) const;
    double slantCosine(double cosTheta) const;
    double g(double cosThetaO, double cosThetaI) const;
    glm::dvec3 mirrorWeight(double cosThetaO) const;
    glm::dvec3 sampleHalfVector(const glm::dvec3& wo, const glm::dvec2& u) const;

    glm::dvec3 f0_;
    double roughness_;
    Masking masking_;
};

} // namespace calotype::reference
