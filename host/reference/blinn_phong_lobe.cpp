#include "reference/blinn_phong_lobe.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

#include "reference/half_vector.h"
#include "reference/warp.h"

namespace calotype::reference {

double BlinnPhongLobe::albedo(const glm::dvec3&) const { return ks_; }

glm::dvec3 BlinnPhongLobe::f(const glm::dvec3& wo, const glm::dvec3& wi) const {
    if (wi.z <= 0.0)
        return glm::dvec3(0.0);
    const glm::dvec3 h = halfVector(wo, wi);
    const double lobe = ks_ * std::pow(h.z, exponent_) / (2.0 * kPi);
    if (!isNormalized_)
        return glm::dvec3(lobe * (exponent_ + 2.0));
    return glm::dvec3(lobe * (exponent_ + 1.0) / (4.0 * glm::dot(wo, h) * std::max(wo.z, wi.z)));
}

double BlinnPhongLobe::pdf(const glm::dvec3& wo, const glm::dvec3& wi) const {
    if (wi.z <= 0.0)
        return 0.0;
    const glm::dvec3 h = halfVector(wo, wi);
    const double halfVectorPdf = (exponent_ + 1.0) / (2.0 * kPi) * std::pow(h.z, exponent_);
    return halfVectorPdf / (4.0 * glm::dot(wo, h));
}

/// The cosine of the half vector is u^(1 / (n + 1)), with 1 - u instead of u, like on the device.
Lobe::Sample BlinnPhongLobe::sample(const glm::dvec3& wo, const glm::dvec3& u) const {
    const glm::dvec3 h = directionAt(std::pow(1.0 - u.x, 1.0 / (exponent_ + 1.0)), u.y);
    return {glm::reflect(-wo, h)};
}

} // namespace calotype::reference
