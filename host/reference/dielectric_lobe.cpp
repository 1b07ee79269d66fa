#include "reference/dielectric_lobe.h"

#include <cmath>

#include "math/square.h"

namespace calotype::reference {
namespace {

/// Light at a smooth boundary, for cosThetaI > 0.
struct Boundary {
    double reflectance; ///< of unpolarised light, by Fresnel's equations; 1 for total reflection
    double cosThetaT;   ///< by Snell's law; 0 for total reflection
};

Boundary boundaryAt(double cosThetaI, double eta) {
    const double sin2ThetaT = (1.0 - square(cosThetaI)) / square(eta);
    if (sin2ThetaT >= 1.0)
        return {1.0, 0.0};
    const double cosThetaT = std::sqrt(1.0 - sin2ThetaT);
    const double parallel = (eta * cosThetaI - cosThetaT) / (eta * cosThetaI + cosThetaT);
    const double perpendicular = (cosThetaI - eta * cosThetaT) / (cosThetaI + eta * cosThetaT);
    return {0.5 * (square(parallel) + square(perpendicular)), cosThetaT};
}

} // namespace

double DielectricLobe::albedo(const glm::dvec3&) const { return 1.0; }

glm::dvec3 DielectricLobe::f(const glm::dvec3&, const glm::dvec3&) const { return glm::dvec3(0.0); }

double DielectricLobe::pdf(const glm::dvec3&, const glm::dvec3&) const { return 0.0; }

Lobe::Sample DielectricLobe::sample(const glm::dvec3& wo, const glm::dvec3& u) const {
    const Boundary boundary = boundaryAt(wo.z, eta_);
    if (u.z < boundary.reflectance)
        return {{-wo.x, -wo.y, wo.z}, true, glm::dvec3(1.0)};
    const glm::dvec3 refracted(-wo.x / eta_, -wo.y / eta_, -boundary.cosThetaT);
    // Crossing the boundary changes the solid angle.
    return {refracted, true, tint_ / (eta_ * eta_), eta_};
}

} // namespace calotype::reference
