#pragma once

#include "reference/light.h"
#include "reference/sample_shape.h"
#include "reference/spherical_triangle.h"
#include "scene/scene.h"

namespace calotype::reference {

/// A primitive that emits (docs/models.md, "Triangle light", "Sphere light" and "Quadric lights").
class ShapeLight final : public Light {
public:
    /// Keeps a reference to the shape. `triangle` is that of a mesh; `area` is in m^2.
    ShapeLight(uint32_t primitive, const Shape& shape, uint32_t triangle, double area,
               const Material& material);

    double area() const { return area_; }
    bool shinesFromBack() const { return shinesFromBack_; }

    Sample sample(const glm::dvec3& shadingPoint, const glm::dvec2& u) const override;
    double pdf(const glm::dvec3& shadingPoint, const glm::dvec3& wi,
               const Point& point) const override;
    glm::dvec3 radiance(const glm::dvec3& wi, const Point& point) const override;
    double maxRadiance() const override;
    bool isHiddenFromCamera() const override { return isHiddenFromCamera_; }

private:
    /// Of this light's triangle, as seen from a shading point.
    bool isSampledBySolidAngle(const SeenTriangle& seen) const;

    /// By solid angle or uniform on the area.
    ShapePoint sampleTriangle(const Mesh& mesh, const glm::dvec3& shadingPoint,
                              const glm::dvec2& u) const;

    const Shape& shape_;
    uint32_t triangle_;
    double area_;
    glm::dvec3 radiance_;
    bool shinesFromBack_;
    bool isHiddenFromCamera_;
};

} // namespace calotype::reference
