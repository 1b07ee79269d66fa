#pragma once

#include "reference/light.h"

namespace calotype::reference {

/// Constant radiance from all directions (docs/models.md, "Background").
class BackgroundLight final : public Light {
public:
    explicit BackgroundLight(const glm::dvec3& radiance) : radiance_(radiance) {}

    Sample sample(const glm::dvec3& shadingPoint, const glm::dvec2& u) const override;
    double pdf(const glm::dvec3& shadingPoint, const glm::dvec3& wi,
               const Point& point) const override;
    glm::dvec3 radiance(const glm::dvec3& wi, const Point& point) const override;
    double maxRadiance() const override;

private:
    glm::dvec3 radiance_;
};

} // namespace calotype::reference
