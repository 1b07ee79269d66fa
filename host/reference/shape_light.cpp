#include "reference/shape_light.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include <glm/geometric.hpp>

#include "reference/warp.h"

namespace calotype::reference {
namespace {

/// The density per area, 1 / area, converted to solid angle (docs/models.md, "Direct light"). Zero
/// if seen edge-on, and if the point is the shading point itself.
double solidAnglePdf(double area, const glm::dvec3& shadingPoint, const glm::dvec3& position,
                     const glm::dvec3& normal) {
    const glm::dvec3 d = position - shadingPoint;
    if (d == glm::dvec3(0.0))
        return 0.0;
    const double cosTheta = std::abs(glm::dot(glm::normalize(d), normal));
    return cosTheta > 0.0 ? glm::dot(d, d) / (cosTheta * area) : 0.0;
}

/// Whether a closed shape hides its own point, with the given outward normal, from `shadingPoint`.
template <typename Geometry>
bool hidesItself(const Geometry& geometry, const glm::dvec3& shadingPoint,
                 const glm::dvec3& position, const glm::dvec3& normal) {
    if constexpr (std::is_same_v<Geometry, Disk> || std::is_same_v<Geometry, Mesh>)
        return false;
    else
        return glm::dot(shadingPoint - position, normal) < 0.0 && !contains(geometry, shadingPoint);
}

/// From outside, spheres are sampled by the cone that they subtend.
template <typename Geometry>
bool isSeenAsCone(const Geometry& geometry, const glm::dvec3& shadingPoint) {
    if constexpr (std::is_same_v<Geometry, Sphere>)
        return !contains(geometry, shadingPoint);
    else
        return false;
}

/// A triangle that is chosen less often is sampled by area (docs/models.md, "Triangle light").
constexpr double kLeastBySolidAngle = 1.0 / 64.0;

/// The corners of a triangle of the mesh, from `shadingPoint`.
SeenTriangle seenTriangle(const Mesh& mesh, uint32_t triangle, const glm::dvec3& shadingPoint) {
    const uint32_t* corners = mesh.triangles[triangle].position;
    return {mesh.positions[corners[0]] - shadingPoint, mesh.positions[corners[1]] - shadingPoint,
            mesh.positions[corners[2]] - shadingPoint};
}

} // namespace

ShapeLight::ShapeLight(uint32_t primitive, const Shape& shape, uint32_t triangle, double area,
                       const Material& material)
    : Light(primitive), shape_(shape), triangle_(triangle), area_(area),
      radiance_(material.emission), shinesFromBack_(!material.emitsFromFrontOnly),
      isHiddenFromCamera_(!material.visibleToCamera) {}

bool ShapeLight::isSampledBySolidAngle(const SeenTriangle& seen) const {
    return selectionProbability >= kLeastBySolidAngle && seen.isSampledBySolidAngle();
}

ShapePoint ShapeLight::sampleTriangle(const Mesh& mesh, const glm::dvec3& shadingPoint,
                                      const glm::dvec2& u) const {
    ShapePoint on = samplePoint(mesh, triangle_, u);
    const SeenTriangle seen = seenTriangle(mesh, triangle_, shadingPoint);
    if (isSampledBySolidAngle(seen)) {
        const glm::dvec3 wi = seen.direction(u);
        const double distance = glm::dot(seen.a, on.normal) / glm::dot(wi, on.normal);
        on.position = shadingPoint + distance * wi;
    }
    return on;
}

Light::Sample ShapeLight::sample(const glm::dvec3& shadingPoint, const glm::dvec2& u) const {
    const ShapePoint on = std::visit(
        [&]<typename G>(const G& geometry) {
            if constexpr (std::is_same_v<G, Mesh>) {
                return sampleTriangle(geometry, shadingPoint, u);
            } else if constexpr (std::is_same_v<G, Sphere>) {
                return isSeenAsCone(geometry, shadingPoint)
                           ? sampleSeenSphere(geometry, shadingPoint, u)
                           : samplePoint(geometry, u);
            } else {
                return samplePoint(geometry, u);
            }
        },
        shape_.geometry);
    const glm::dvec3 wi = glm::normalize(on.position - shadingPoint);
    const Point point{on.position, on.normal};
    return {wi, point, pdf(shadingPoint, wi, point)};
}

double ShapeLight::pdf(const glm::dvec3& shadingPoint, const glm::dvec3&,
                       const Point& point) const {
    return std::visit(
        [&]<typename G>(const G& geometry) {
            if constexpr (std::is_same_v<G, Sphere>) {
                if (isSeenAsCone(geometry, shadingPoint)) {
                    const bool isFarSide =
                        glm::dot(shadingPoint - point.position, point.normal) < 0.0;
                    return isFarSide ? 0.0 : sphereConePdf(geometry, shadingPoint);
                }
            }
            if constexpr (std::is_same_v<G, Mesh>) {
                const SeenTriangle seen = seenTriangle(geometry, triangle_, shadingPoint);
                if (isSampledBySolidAngle(seen))
                    return 1.0 / seen.solidAngle();
            }
            return hidesItself(geometry, shadingPoint, point.position, point.normal)
                       ? 0.0
                       : solidAnglePdf(area_, shadingPoint, point.position, point.normal);
        },
        shape_.geometry);
}

glm::dvec3 ShapeLight::radiance(const glm::dvec3& wi, const Point& point) const {
    return glm::dot(point.normal, wi) < 0.0 || shinesFromBack_ ? radiance_ : glm::dvec3(0.0);
}

double ShapeLight::maxRadiance() const { return std::max({radiance_.x, radiance_.y, radiance_.z}); }

} // namespace calotype::reference
