#include "reference/background_light.h"

#include <algorithm>

#include "reference/warp.h"

namespace calotype::reference {

Light::Sample BackgroundLight::sample(const glm::dvec3&, const glm::dvec2& u) const {
    return {warpToSphere(u), {}, 1.0 / (4.0 * kPi)};
}

double BackgroundLight::pdf(const glm::dvec3&, const glm::dvec3&, const Point&) const {
    return 1.0 / (4.0 * kPi);
}

glm::dvec3 BackgroundLight::radiance(const glm::dvec3&, const Point&) const { return radiance_; }

double BackgroundLight::maxRadiance() const {
    return std::max({radiance_.x, radiance_.y, radiance_.z});
}

} // namespace calotype::reference
