#include "reference/diffuse_lobe.h"

#include <algorithm>

#include "reference/warp.h"

namespace calotype::reference {

double DiffuseLobe::albedo(const glm::dvec3&) const {
    return std::max({reflectance_.x, reflectance_.y, reflectance_.z});
}

glm::dvec3 DiffuseLobe::f(const glm::dvec3&, const glm::dvec3& wi) const {
    return wi.z > 0.0 ? reflectance_ / kPi : glm::dvec3(0.0);
}

double DiffuseLobe::pdf(const glm::dvec3&, const glm::dvec3& wi) const {
    return std::max(wi.z, 0.0) / kPi;
}

Lobe::Sample DiffuseLobe::sample(const glm::dvec3&, const glm::dvec3& u) const {
    return {warpToCosineHemisphere(glm::dvec2(u))};
}

} // namespace calotype::reference
