#include "check/coplanar_lights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <span>
#include <sstream>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "scene/place.h"

namespace calotype {
namespace {

/// Relative to a light's distance from the camera: the device separates surfaces at this distance
/// from each other (CoplanarLightTest in tests/extremes), but confuses some at a tenth of it.
constexpr double kGap = 1e-6;
constexpr double kMostPairs = 1e7;

/// A triangle; or a disk, the cap of a cylinder or the base of a cone, as a polygon inside it. The
/// polygon is smaller by 2 % of the radius at most.
struct Facet {
    static constexpr size_t kMostCorners = 16;

    size_t shape = 0;
    size_t number = 0; ///< within the shape
    bool shines = false;
    bool isOfSolid = false; ///< visible from the side of its normal only
    glm::dvec3 normal{0.0}; ///< unit
    size_t cornerCount = 0;
    std::array<glm::dvec3, kMostCorners> polygon{};

    std::span<const glm::dvec3> corners() const { return {polygon.data(), cornerCount}; }
};

/// A disk about the axis y of a frame, `height` above its origin.
Facet facetOfDisk(const RigidTransform& worldFromObject, double height, double radius) {
    const glm::dmat3& frame = worldFromObject.rotation;
    Facet facet;
    facet.normal = frame[1];
    facet.cornerCount = Facet::kMostCorners;
    for (size_t i = 0; i < facet.cornerCount; ++i) {
        const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) /
                             static_cast<double>(facet.cornerCount);
        facet.polygon[i] = worldFromObject.translation + height * frame[1] +
                           radius * (std::sin(angle) * frame[0] + std::cos(angle) * frame[2]);
    }
    return facet;
}

/// The cap or base of a solid at `height`; the solid is between it and the frame's origin.
Facet endOfSolid(const RigidTransform& worldFromObject, double height, double radius) {
    Facet facet = facetOfDisk(worldFromObject, height, radius);
    facet.isOfSolid = true;
    facet.normal *= height < 0.0 ? -1.0 : 1.0;
    return facet;
}

Facet facetOf(const Mesh& mesh, const Mesh::Triangle& triangle) {
    Facet facet;
    facet.cornerCount = 3;
    for (size_t i = 0; i < 3; ++i)
        facet.polygon[i] = mesh.positions[triangle.position[i]];
    facet.normal = glm::normalize(
        glm::cross(facet.polygon[1] - facet.polygon[0], facet.polygon[2] - facet.polygon[0]));
    return facet;
}

bool emits(const Material& material) { return material.emission != glm::dvec3(0.0); }

/// Calls visit(facet) for every flat part of the scene but the triangles for which
/// `leavesOut(mesh, triangle)` holds.
template <typename LeavesOut, typename Visit>
void forEachFacet(const Scene& scene, const LeavesOut& leavesOut, const Visit& visit) {
    for (size_t i = 0; i < scene.shapes.size(); ++i) {
        const Shape& shape = scene.shapes[i];
        size_t number = 0;
        const auto visitOne = [&](Facet facet, uint32_t material) {
            facet.shape = i;
            facet.number = number++;
            facet.shines = emits(scene.materials[material]);
            visit(facet);
        };
        if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
            visitOne(facetOfDisk(disk->worldFromObject, 0.0, disk->radius), shape.material);
        } else if (const auto* cylinder = std::get_if<Cylinder>(&shape.geometry)) {
            for (const double height : {-0.5 * cylinder->height, 0.5 * cylinder->height}) {
                visitOne(endOfSolid(cylinder->worldFromObject, height, cylinder->radius),
                         shape.material);
            }
        } else if (const auto* cone = std::get_if<Cone>(&shape.geometry)) {
            const double radius = cone->slope * std::abs(cone->height);
            visitOne(endOfSolid(cone->worldFromObject, cone->height, radius), shape.material);
        } else if (const auto* mesh = std::get_if<Mesh>(&shape.geometry)) {
            for (const Mesh::Triangle& triangle : mesh->triangles)
                if (leavesOut(*mesh, triangle))
                    ++number;
                else
                    visitOne(facetOf(*mesh, triangle), triangle.material);
        }
    }
}

/// The interval of the facet along an axis.
glm::dvec2 reach(const Facet& facet, const glm::dvec3& axis) {
    glm::dvec2 reach(std::numeric_limits<double>::infinity(),
                     -std::numeric_limits<double>::infinity());
    for (const glm::dvec3& corner : facet.corners()) {
        const double along = glm::dot(axis, corner);
        reach = {std::min(reach.x, along), std::max(reach.y, along)};
    }
    return reach;
}

/// True if a line along an edge of `a` separates the two, up to an overlap of `tolerance`.
bool isPartedByAnEdge(const Facet& a, const Facet& b, double tolerance) {
    const std::span<const glm::dvec3> corners = a.corners();
    for (size_t i = 0; i < corners.size(); ++i) {
        const glm::dvec3 edge = corners[(i + 1) % corners.size()] - corners[i];
        const glm::dvec3 axis = glm::normalize(glm::cross(edge, a.normal));
        const glm::dvec2 reachOfA = reach(a, axis);
        const glm::dvec2 reachOfB = reach(b, axis);
        if (std::min(reachOfA.y, reachOfB.y) - std::max(reachOfA.x, reachOfB.x) < tolerance)
            return true;
    }
    return false;
}

/// Whether two convex polygons in one plane overlap (separating axes).
bool overlap(const Facet& a, const Facet& b, double tolerance) {
    return !isPartedByAnEdge(a, b, tolerance) && !isPartedByAnEdge(b, a, tolerance);
}

bool isInPlaneOf(const Facet& light, const Facet& other, double tolerance) {
    return std::ranges::all_of(light.corners(), [&](const glm::dvec3& corner) {
        return std::abs(glm::dot(other.normal, corner - other.polygon[0])) < tolerance;
    });
}

/// Whether the first corner of the light is so far from the triangle's plane that isInPlaneOf is
/// false; most triangles take no more than this.
bool isFarFromPlaneOf(const Facet& light, const Mesh& mesh, const Mesh::Triangle& triangle,
                      double tolerance) {
    constexpr double kRounding = 2.0; // isInPlaneOf has a unit normal, which rounds
    const glm::dvec3& a = mesh.positions[triangle.position[0]];
    const glm::dvec3 normal = glm::cross(mesh.positions[triangle.position[1]] - a,
                                         mesh.positions[triangle.position[2]] - a);
    const double along = glm::dot(normal, light.polygon[0] - a);
    const double most = kRounding * tolerance;
    return along * along > most * most * glm::dot(normal, normal);
}

/// False for the bottom of a solid on a floor: the solid hides its own end and the floor below.
bool canBeSeen(const Facet& facet, const glm::dvec3& camera) {
    return !facet.isOfSolid || glm::dot(facet.normal, camera - facet.polygon[0]) > 0.0;
}

bool isItself(const Facet& a, const Facet& b) { return a.shape == b.shape && a.number == b.number; }

void warn(const Scene& scene, Warnings& warnings, const Facet& light, const Facet& other,
          double gap) {
    std::ostringstream message;
    message.precision(1);
    message << "lies in the plane of "
            << (light.shape == other.shape ? "other triangles of its own"
                                           : placeOfShape(scene, other.shape))
            << ", so that rounding decides which of the two is seen; move it off by " << gap
            << " m or more";
    warnings.add(placeOfShape(scene, light.shape), message.str(), "coplanar lights");
}

} // namespace

void warnOfCoplanarLights(const Scene& scene, Warnings& warnings) {
    struct Light {
        Facet facet;
        double gap;
    };
    std::vector<Light> lights;
    double facets = 0.0;
    forEachFacet(
        scene,
        [&](const Mesh&, const Mesh::Triangle& triangle) {
            const bool shines = emits(scene.materials[triangle.material]);
            facets += shines ? 0.0 : 1.0;
            return !shines;
        },
        [&](const Facet& facet) {
            facets += 1.0;
            if (facet.shines && canBeSeen(facet, scene.camera.position))
                lights.push_back(
                    {facet, kGap * glm::distance(facet.polygon[0], scene.camera.position)});
        });
    if (lights.empty() || static_cast<double>(lights.size()) * facets > kMostPairs)
        return;
    std::set<size_t> coplanar;
    forEachFacet(
        scene,
        [&](const Mesh& mesh, const Mesh::Triangle& triangle) {
            return std::ranges::all_of(lights, [&](const Light& light) {
                return isFarFromPlaneOf(light.facet, mesh, triangle, light.gap);
            });
        },
        [&](const Facet& other) {
            if (!canBeSeen(other, scene.camera.position))
                return;
            for (const auto& [light, gap] : lights) {
                if (!isItself(light, other) && isInPlaneOf(light, other, gap) &&
                    !coplanar.contains(light.shape) && overlap(light, other, gap)) {
                    coplanar.insert(light.shape);
                    warn(scene, warnings, light, other, gap);
                }
            }
        });
}

} // namespace calotype
