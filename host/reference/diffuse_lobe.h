#pragma once

#include "reference/lobe.h"

namespace calotype::reference {

/// Lambertian reflection (docs/models.md, "Lambert").
class DiffuseLobe final : public Lobe {
public:
    explicit DiffuseLobe(const glm::dvec3& reflectance) : reflectance_(reflectance) {}

    double albedo(const glm::dvec3& wo) const override;
    glm::dvec3 f(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override;

private:
    glm::dvec3 reflectance_;
};

} // namespace calotype::reference
