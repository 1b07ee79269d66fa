#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.h"

/// The lobes of the report's materials, its equations taken at their word. Directions are unit
/// vectors in the shading frame: z is the shading normal, on the viewer's side. `f` is the BSDF in
/// 1/sr, without the cosine.
namespace calotype::reference {

/// Schlick's approximation (eq. 1.29).
glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double cosTheta);

/// Cook-Torrance with GGX microfacets (eq. 1.27 to 1.30), or Smith's height-correlated masking
/// (Heitz 2014, eq. 99).
struct Ggx {
    glm::dvec3 f0{0.0};
    double roughness = 0.0; ///< alpha is its square
    Masking masking = Masking::Schlick;

    double alpha() const { return roughness * roughness; }
    glm::dvec3 f(const glm::dvec3& wo, const glm::dvec3& wi) const;
    /// Of the half vectors that the viewer sees, as a density of wi per solid angle.
    double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const;
    /// A half vector that the viewer sees (Dupuy and Benyoub 2023).
    glm::dvec3 sampleHalfVector(const glm::dvec3& wo, const glm::dvec2& u) const;
    /// Of the limit of no roughness, in the mirrored direction: F G1(wo)^2.
    glm::dvec3 mirrorWeight(double cosThetaO) const;

private:
    double d(double cosThetaH) const;
    double g1(double cosTheta) const;
    double slantCosine(double cosTheta) const;
    double g(double cosThetaO, double cosThetaI) const;
};

/// Blinn-Phong's specular lobe with a half vector (eq. 1.24 to 1.26), or the normalised one:
/// ks (n + 1) / (2 pi) cos^n a / (4 (wo.h) max(cosThetaO, cosThetaI)).
struct BlinnPhong {
    double ks = 0.0;
    double exponent = 0.0;
    bool isNormalized = false;

    double f(const glm::dvec3& wo, const glm::dvec3& wi) const;
    double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const; ///< of wi, per solid angle
    glm::dvec3 sampleHalfVector(const glm::dvec2& u) const;
};

/// What a smooth boundary does to light that meets it at cosThetaI > 0; `eta` is the index of
/// refraction beyond it over that before it.
struct Boundary {
    double reflectance; ///< of unpolarised light, by Fresnel's equations; 1 for total reflection
    double cosThetaT;   ///< by Snell's law (eq. 1.34); 0 for total reflection
};
Boundary boundaryAt(double cosThetaI, double eta);

} // namespace calotype::reference
