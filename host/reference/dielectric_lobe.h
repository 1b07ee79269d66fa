#pragma once

#include "reference/lobe.h"

namespace calotype::reference {

/// A smooth boundary between two dielectrics (docs/models.md, "Dielectric").
class DielectricLobe final : public Lobe {
public:
    /// `tint` is the colour of light that crosses; `eta` is the index of refraction on the far side
    /// over that on the viewer's.
    DielectricLobe(const glm::dvec3& tint, double eta) : tint_(tint), eta_(eta) {}

    bool isSpecular() const override { return true; }
    double albedo(const glm::dvec3& wo) const override;
    glm::dvec3 f(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    double pdf(const glm::dvec3& wo, const glm::dvec3& wi) const override;
    /// u.z chooses between the reflected and the refracted direction.
    Sample sample(const glm::dvec3& wo, const glm::dvec3& u) const override;

private:
    glm::dvec3 tint_;
    double eta_;
};

} // namespace calotype::reference
