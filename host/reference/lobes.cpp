#include "reference/lobes.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "reference/warp.h"

namespace calotype::reference {
namespace {

glm::dvec3 halfVector(const glm::dvec3& wo, const glm::dvec3& wi) {
    return glm::normalize(wo + wi);
}

double square(double x) { return x * x; }

} // namespace

glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double cosTheta) {
    return f0 + (1.0 - f0) * std::pow(1.0 - std::min(cosTheta, 1.0), 5.0);
}

double Ggx::d(double cosThetaH) const {
    const double alpha2 = square(alpha());
    return alpha2 / (kPi * square(square(cosThetaH) * (alpha2 - 1.0) + 1.0));
}

double Ggx::g1(double cosTheta) const {
    const double k = square(roughness + 1.0) / 8.0;
    return cosTheta / (cosTheta * (1.0 - k) + k);
}

/// sqrt(alpha^2 + (1 - alpha^2) cos^2), which is cos (1 + 2 Lambda) in Heitz's terms.
double Ggx::slantCosine(double cosTheta) const {
    const double alpha2 = square(alpha());
    return std::sqrt(alpha2 + (1.0 - alpha2) * square(cosTheta));
}

double Ggx::g(double cosThetaO, double cosThetaI) const {
    if (masking == Masking::Schlick)
        return g1(cosThetaO) * g1(cosThetaI);
    return 2.0 * cosThetaO * cosThetaI /
           (cosThetaO * slantCosine(cosThetaI) + cosThetaI * slantCosine(cosThetaO));
}

glm::dvec3 Ggx::f(const glm::dvec3& wo, const glm::dvec3& wi) const {
    const glm::dvec3 h = halfVector(wo, wi);
    return d(h.z) * g(wo.z, wi.z) / (4.0 * wo.z * wi.z) * fresnelSchlick(f0, glm::dot(wo, h));
}

/// D_visible(h) = G1 max(0, wo.h) D / cosThetaO with Smith's G1, times the Jacobian 1 / (4 wo.h).
double Ggx::pdf(const glm::dvec3& wo, const glm::dvec3& wi) const {
    const double smithG1 = 2.0 * wo.z / (wo.z + slantCosine(wo.z));
    return smithG1 * d(halfVector(wo, wi).z) / (4.0 * wo.z);
}

/// Stretched until the facets are a hemisphere, the visible half vectors are the sums of the viewer
/// and the directions of a spherical cap, uniform on it.
glm::dvec3 Ggx::sampleHalfVector(const glm::dvec3& wo, const glm::dvec2& u) const {
    const double a = alpha();
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(a * wo.x, a * wo.y, wo.z));
    const glm::dvec3 onCap = directionAt((1.0 - u.y) * (1.0 + viewer.z) - viewer.z, u.x);
    const glm::dvec3 h = viewer + onCap;
    return glm::normalize(glm::dvec3(a * h.x, a * h.y, std::max(h.z, 0.0)));
}

glm::dvec3 Ggx::mirrorWeight(double cosThetaO) const {
    const double masked = masking == Masking::Schlick ? square(g1(cosThetaO)) : 1.0;
    return masked * fresnelSchlick(f0, cosThetaO);
}

double BlinnPhong::f(const glm::dvec3& wo, const glm::dvec3& wi) const {
    const glm::dvec3 h = halfVector(wo, wi);
    const double lobe = ks * std::pow(h.z, exponent) / (2.0 * kPi);
    if (!isNormalized)
        return lobe * (exponent + 2.0);
    return lobe * (exponent + 1.0) / (4.0 * glm::dot(wo, h) * std::max(wo.z, wi.z));
}

double BlinnPhong::pdf(const glm::dvec3& wo, const glm::dvec3& wi) const {
    const glm::dvec3 h = halfVector(wo, wi);
    const double halfVectorPdf = (exponent + 1.0) / (2.0 * kPi) * std::pow(h.z, exponent);
    return halfVectorPdf / (4.0 * glm::dot(wo, h));
}

/// cosThetaH is u^(1 / (n + 1)) (eq. 1.25), with 1 - u in u's place, as the device has it.
glm::dvec3 BlinnPhong::sampleHalfVector(const glm::dvec2& u) const {
    return directionAt(std::pow(1.0 - u.x, 1.0 / (exponent + 1.0)), u.y);
}

Boundary boundaryAt(double cosThetaI, double eta) {
    const double sin2ThetaT = (1.0 - square(cosThetaI)) / square(eta);
    if (sin2ThetaT >= 1.0)
        return {1.0, 0.0};
    const double cosThetaT = std::sqrt(1.0 - sin2ThetaT);
    const double parallel = (eta * cosThetaI - cosThetaT) / (eta * cosThetaI + cosThetaT);
    const double perpendicular = (cosThetaI - eta * cosThetaT) / (cosThetaI + eta * cosThetaT);
    return {0.5 * (square(parallel) + square(perpendicular)), cosThetaT};
}

} // namespace calotype::reference
