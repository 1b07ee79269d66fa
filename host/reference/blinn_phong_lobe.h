#pragma once

#include "reference/lobe.h"

namespace calotype::reference {

/// The specular lobe of Blinn-Phong around the half vector, or the normalised one (docs/models.md,
/// "Blinn-Phong").
class BlinnPhongLobe final : public Lobe {
public:
    BlinnPhongLobe(double ks, double exponent, bool isNormalized)
        : ks_(ks), exponent_(exponent), isNormalized_(isNormalized) {}

    double albedo(const glm::dvec3& wo) const override;
    glm::dvec3 f(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override;

private:
    double ks_;
    double exponent_;
    bool isNormalized_;
};

} // namespace calotype::reference
