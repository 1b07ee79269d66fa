#include "scene/light_cluster.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "math/greatest.h"
#include "math/luminance.h"
#include "scene/scene_bounds.h"

namespace calotype {
namespace {

constexpr double kPi = std::numbers::pi;

bool shines(const Material& material) { return greatest(material.emission) > 0.0; }

double angleBetween(const glm::dvec3& a, const glm::dvec3& b) {
    return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double areaOf(const Sphere& sphere) { return 4.0 * kPi * sphere.radius * sphere.radius; }
double areaOf(const Cylinder& cylinder) {
    return 2.0 * kPi * cylinder.radius * (cylinder.radius + cylinder.height);
}
double areaOf(const Cone& cone) {
    const double radius = cone.slope * std::abs(cone.height);
    return kPi * radius * (radius + std::hypot(radius, cone.height));
}
double areaOf(const Disk& disk) { return kPi * disk.radius * disk.radius; }

/// A closed surface shines in all directions.
template <typename Closed>
LightCluster facing(const Closed&) {
    LightCluster cluster;
    cluster.thetaO = kPi;
    return cluster;
}

LightCluster facing(const Disk& disk) {
    LightCluster cluster;
    cluster.axis = disk.worldFromObject.rotation[1];
    return cluster;
}

void addLit(std::vector<PrimitiveLight>& lights, uint32_t primitive, LightCluster cluster,
            double area, const Material& material) {
    if (area <= 0.0)
        return;
    const double sides = material.emitsFromFrontOnly ? 1.0 : 2.0;
    cluster.isTwoSided = !material.emitsFromFrontOnly && cluster.thetaO < kPi;
    cluster.power = luminance(material.emission) * area * sides;
    lights.push_back({primitive, cluster});
}

void addTriangles(std::vector<PrimitiveLight>& lights, uint32_t first, const Mesh& mesh,
                  const std::vector<Material>& materials) {
    for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
        const Material& material = materials[mesh.triangles[i].material];
        if (!shines(material))
            continue;
        const uint32_t* corners = mesh.triangles[i].position;
        const glm::dvec3& v0 = mesh.positions[corners[0]];
        const glm::dvec3 normal =
            glm::cross(mesh.positions[corners[1]] - v0, mesh.positions[corners[2]] - v0);
        const double length = glm::length(normal);
        LightCluster cluster;
        for (int corner = 0; corner < 3; ++corner)
            cluster.bounds.extend(mesh.positions[corners[corner]]);
        cluster.axis = length > 0.0 ? normal / length : cluster.axis;
        addLit(lights, first + i, cluster, 0.5 * length, material);
    }
}

bool anyShines(const Scene& scene) { return std::ranges::any_of(scene.materials, shines); }

/// The axis of a cone that contains the cones a and b, and its angle.
struct NormalCone {
    glm::dvec3 axis;
    double thetaO;
};

/// The direction at this angle from a, towards b.
glm::dvec3 turned(const glm::dvec3& a, const glm::dvec3& b, double angle) {
    const glm::dvec3 across = glm::normalize(b - glm::dot(a, b) * a);
    return glm::normalize(std::cos(angle) * a + std::sin(angle) * across);
}

NormalCone joinedCones(const NormalCone& a, const NormalCone& b) {
    if (a.thetaO >= kPi || b.thetaO >= kPi)
        return a.thetaO >= kPi ? a : b;
    const double between = angleBetween(a.axis, b.axis);
    if (std::min(between + b.thetaO, kPi) <= a.thetaO)
        return a;
    if (std::min(between + a.thetaO, kPi) <= b.thetaO)
        return b;
    const double thetaO = 0.5 * (a.thetaO + between + b.thetaO);
    const bool isOpposite = glm::length(glm::cross(a.axis, b.axis)) < 1e-9 && between > 1.0;
    if (thetaO >= kPi || isOpposite)
        return {a.axis, kPi};
    if (glm::length(b.axis - glm::dot(a.axis, b.axis) * a.axis) == 0.0)
        return {a.axis, thetaO};
    return {turned(a.axis, b.axis, thetaO - a.thetaO), thetaO};
}

} // namespace

LightCluster joined(const LightCluster& a, const LightCluster& b) {
    LightCluster both = a;
    both.bounds.extend(b.bounds);
    both.power = a.power + b.power;
    both.isTwoSided = a.isTwoSided || b.isTwoSided;
    const double side = both.isTwoSided && glm::dot(a.axis, b.axis) < 0.0 ? -1.0 : 1.0;
    const NormalCone cone = joinedCones({a.axis, a.thetaO}, {side * b.axis, b.thetaO});
    both.axis = cone.axis;
    both.thetaO = cone.thetaO;
    return both;
}

std::vector<PrimitiveLight> primitiveLights(const Scene& scene) {
    std::vector<PrimitiveLight> lights;
    if (!anyShines(scene))
        return lights;
    uint32_t primitive = 0;
    for (const Shape& shape : scene.shapes)
        std::visit(
            [&]<typename Geometry>(const Geometry& geometry) {
                if constexpr (std::is_same_v<Geometry, Mesh>) {
                    addTriangles(lights, primitive, geometry, scene.materials);
                    primitive += static_cast<uint32_t>(geometry.triangles.size());
                } else {
                    const Material& material = scene.materials[shape.material];
                    LightCluster cluster = facing(geometry);
                    cluster.bounds = shapeBounds(shape);
                    if (shines(material))
                        addLit(lights, primitive, cluster, areaOf(geometry), material);
                    ++primitive;
                }
            },
            shape.geometry);
    return lights;
}

bool hasMorePrimitiveLightsThan(uint32_t count, const Scene& scene) {
    if (!anyShines(scene))
        return false;
    uint32_t found = 0;
    for (const Shape& shape : scene.shapes) {
        if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (const Mesh::Triangle& triangle : mesh->triangles)
                if (shines(scene.materials[triangle.material]) && ++found > count)
                    return true;
        } else if (shines(scene.materials[shape.material]) && ++found > count) {
            return true;
        }
    }
    return false;
}

} // namespace calotype
