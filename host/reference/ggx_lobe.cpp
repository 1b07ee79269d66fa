#include "reference/ggx_lobe.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "math/square.h"
#include "reference/half_vector.h"
#include "reference/warp.h"

namespace calotype::reference {
glm::dvec3 fresnelSchlick(const glm::dvec3& f0, double cosTheta) {
    return f0 + (1.0 - f0) * std::pow(1.0 - std::min(cosTheta, 1.0), 5.0);
}

double GgxLobe::albedo(const glm::dvec3& wo) const {
    const glm::dvec3 reflected = fresnelSchlick(f0_, wo.z);
    return std::max({reflected.x, reflected.y, reflected.z});
}

double GgxLobe::d(double cosThetaH) const {
    const double alpha2 = square(alpha());
    return alpha2 / (kPi * square(square(cosThetaH) * (alpha2 - 1.0) + 1.0));
}

double GgxLobe::g1(double cosTheta) const {
    const double k = square(roughness_ + 1.0) / 8.0;
    return cosTheta / (cosTheta * (1.0 - k) + k);
}

/// sqrt(alpha^2 + (1 - alpha^2) cos^2), which is cos (1 + 2 Lambda) in Heitz's terms.
double GgxLobe::slantCosine(double cosTheta) const {
    const double alpha2 = square(alpha());
    return std::sqrt(alpha2 + (1.0 - alpha2) * square(cosTheta));
}

double GgxLobe::g(double cosThetaO, double cosThetaI) const {
    if (masking_ == Masking::Schlick)
        return g1(cosThetaO) * g1(cosThetaI);
    return 2.0 * cosThetaO * cosThetaI /
           (cosThetaO * slantCosine(cosThetaI) + cosThetaI * slantCosine(cosThetaO));
}

glm::dvec3 GgxLobe::f(const glm::dvec3& wo, const glm::dvec3& wi) const {
    if (isSpecular() || wi.z <= 0.0)
        return glm::dvec3(0.0);
    const glm::dvec3 h = halfVector(wo, wi);
    return d(h.z) * g(wo.z, wi.z) / (4.0 * wo.z * wi.z) * fresnelSchlick(f0_, glm::dot(wo, h));
}

/// The density of visible half vectors: D_visible(h) = G1 max(0, wo.h) D / cosThetaO with Smith's
/// G1, times the Jacobian 1 / (4 wo.h).
double GgxLobe::pdf(const glm::dvec3& wo, const glm::dvec3& wi) const {
    if (isSpecular() || wi.z <= 0.0)
        return 0.0;
    const double smithG1 = 2.0 * wo.z / (wo.z + slantCosine(wo.z));
    return smithG1 * d(halfVector(wo, wi).z) / (4.0 * wo.z);
}

/// F G1(wo)^2, the limit of zero roughness; Smith's G1 approaches 1.
glm::dvec3 GgxLobe::mirrorWeight(double cosThetaO) const {
    const double masked = masking_ == Masking::Schlick ? square(g1(cosThetaO)) : 1.0;
    return masked * fresnelSchlick(f0_, cosThetaO);
}

/// Samples a visible half vector (Dupuy and Benyoub 2023). In the space where the microfacets are a
/// hemisphere, it is the sum of the viewer's direction and a uniform direction in a spherical cap.
glm::dvec3 GgxLobe::sampleHalfVector(const glm::dvec3& wo, const glm::dvec2& u) const {
    const double a = alpha();
    const glm::dvec3 viewer = glm::normalize(glm::dvec3(a * wo.x, a * wo.y, wo.z));
    const glm::dvec3 onCap = directionAt((1.0 - u.y) * (1.0 + viewer.z) - viewer.z, u.x);
    const glm::dvec3 h = viewer + onCap;
    return glm::normalize(glm::dvec3(a * h.x, a * h.y, std::max(h.z, 0.0)));
}

Lobe::Sample GgxLobe::sample(const glm::dvec3& wo, const glm::dvec3& u) const {
    if (isSpecular())
        return {{-wo.x, -wo.y, wo.z}, true, mirrorWeight(wo.z)};
    return {glm::reflect(-wo, sampleHalfVector(wo, glm::dvec2(u)))};
}

} // namespace calotype::reference
